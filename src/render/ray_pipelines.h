// The pipelines of the ray tracer's passes, specialised for a plan and for the primitives that there are. Inside this room only.
#pragma once

#include "render/raytrace.h"

namespace lightbench {

// Effects of rays by which a hit sends others on.
constexpr std::uint32_t kSpawns = RAY_REFLECTED | RAY_REFRACTED | RAY_STRAIGHT;

// Made when it is first asked for. `more`: RAY_... bits of this dispatch, besides those of the plan and of the scene.
const gpu::ComputePipeline& pipeline_of(RayTracer& tracer, const RayWork& work, RayPass pass, std::uint32_t more = 0);

} // namespace lightbench
