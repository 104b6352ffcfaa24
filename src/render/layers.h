// Transparency without refraction (S13): I = t If + (1 - t) Ib for any number of layers in any draw order. The translucent fragments of each
// pixel are counted, listed where the counts say, put into order of depth and blended over the opaque radiance; no fragment is ever lost:
// the lists are as long as the counts, and an image whose lists do not fit one buffer is done in tiles.
// In: a drawing whose opaque part is recorded. Out: its radiance with the layers in front.
#pragma once

#include "render/layer_tiles.h"
#include "render/raster.h"

#include <map>
#include <tuple>

namespace lightbench {

// Made once a scene; buffers grow as images need them.
struct Layers {
    gpu::Buffer counts, cursors, blocks, records, surfaces, opacities, deep_pixels;
    std::array<gpu::Buffer, 2> keys; // of pixels with many layers: the sort goes back and forth
    std::map<std::tuple<std::string, std::uint32_t, std::uint32_t>, gpu::ComputePipeline> pipelines; // by shader, effects, number
    std::uint64_t largest = 0; // bytes that a list may have; 0: what the device allows
};

struct LayerWork {
    gpu::Device& device;
    gpu::Recorder& recorder; // its passes so far are submitted on the way
    const Plan& plan;
    GpuScene& scene;
    const RasterGeometry& geometry;
    const RasterVariant& variant;
    const RasterPipelines& pipelines;
    RasterTargets& targets;
    const RasterDraw& draw;
    gpu::Timings& times; // of what was submitted; appended
};

// What is recorded last may not be submitted yet. Returns the number of translucent triangles drawn.
// EnvironmentError if the layers of one pixel alone do not fit, or are more than a sort can take.
std::size_t record_layers(Layers& layers, const LayerWork& work);

} // namespace lightbench
