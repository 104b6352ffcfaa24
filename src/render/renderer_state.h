// What a renderer owns, and what all its methods do with it. Inside this room only.
#pragma once

#include "gpu/recorder.h"
#include "render/display.h"
#include "render/layers.h"
#include "render/radiosity/radiosity.h"
#include "render/raster.h"
#include "render/raytrace.h"
#include "render/sampling.h"

#include <map>

namespace lightbench {

struct RendererState {
    gpu::Device& device;
    const RasterGeometry& geometry;
    Plan plan;
    Environment environment;
    GpuScene scene;
    gpu::Recorder recorder;
    RasterTargets targets; // of the image
    RasterTargets single;  // of layers that must not be averaged; made when first needed
    gpu::Image sum;        // of frames and pieces; none if there is one of both
    Display display;
    std::map<RasterVariant, RasterPipelines> pipelines;
    Layers layers;
    gpu::Timings times; // of what was submitted on the way
    std::optional<RayTracer> tracer;
    std::optional<WideFilter> filter;
    std::optional<Lattice> lattice;
    std::optional<Radiosity> radiosity;
};

// Ray trees become pixels at once.
bool has_no_image(const Plan& plan);

// Frames of a regular n x n grid within the pixel, or jittered within its cells: the shift of frame i.
glm::dvec2 shift_of(const Plan& plan, unsigned i);

// Made when they are first asked for.
const RasterPipelines& pipelines_for(RendererState& state, const RasterVariant& variant);

ImageF read_crop(RendererState& state, gpu::Image& image);

// Pixels or radiance of the crop, as the plan asks. Submits.
void read_output(RendererState& state, gpu::Image& image, RenderOutput& out);

} // namespace lightbench
