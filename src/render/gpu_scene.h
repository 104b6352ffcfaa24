// The scene on the device: only the buffers that the plan reads. In: scene, tessellation, plan. Out: owned buffers.
#pragma once

#include "gpu/recorder.h"
#include "plan/plan.h"
#include "scene/tessellate.h"

namespace lightbench {

// Buffers that the plan does not name do not exist (they are none).
struct GpuScene {
    gpu::Buffer lights, materials, texels;                          // tables
    gpu::Buffer positions, normals, detail, indices;                // vertices
    gpu::Buffer polygon_positions, polygon_normals, polygon_detail; // points to shade, flat
    gpu::Buffer polygon_objects;                                    // table, for the object layer
    gpu::Buffer vertex_colors, polygon_colors;                      // what shading points wrote
    std::uint32_t vertex_count = 0, polygon_count = 0, light_count = 0;
    gpu_layout::TexelInfo environment{};
    double cube_milliseconds = 0;    // device, of the views from objects that mirror
    std::uint32_t fetch_storage = 0; // FETCH_... bits of the tables that are no texel buffers here
};

GpuScene upload_scene(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan);

// The offer of one table for FETCH_TABLE(name, ...): as texels and as storage; the pipeline takes what it was specialised for.
void offer_table(gpu::Bindings& bindings, std::string_view name, gpu::Buffer& buffer);

} // namespace lightbench
