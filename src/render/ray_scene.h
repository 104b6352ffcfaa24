// What rays are traced through, on the device: primitives and the structure over them. In: scene, tessellation, plan. Out: owned buffers.
#pragma once

#include "accel/accel.h"
#include "gpu/recorder.h"
#include "plan/plan.h"

namespace lightbench {

struct RayScene {
    gpu::Buffer nodes, narrow, triangles, spheres, shapes, corners; // tables; none where there is nothing to hold
    std::uint32_t effects = 0;                                      // RAY_... bits of the primitives that there are
    std::uint32_t stack = 2;                                        // entries that a walk needs
    std::uint32_t loose = 0;                                        // CONSTANT_LOOSE
    std::uint32_t triangle_count = 0, sphere_count = 0, shape_count = 0;
    std::uint32_t fetch_storage = 0; // FETCH_... bits of the tables that are no texel buffers here
    std::size_t structure_bytes = 0;
    RayPrimitives media; // those of surfaces that light is refracted by, where some are
    AccelTables accel;   // without its tables: what building it took
};

// The narrow tree's planes are whole numbers; its first texels say of what.
void prepend_planes(AccelTables& tables);

RayScene upload_rays(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan);

} // namespace lightbench
