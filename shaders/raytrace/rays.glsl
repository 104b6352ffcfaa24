// What every pass over rays shares: its specialisation, the tables of primitives, rays and nodes of the ray tree.
#ifndef LIGHTBENCH_RAYTRACE_RAYS_GLSL
#define LIGHTBENCH_RAYTRACE_RAYS_GLSL

#include "shared/effects.h"
#include "shared/rays.h"
#include "fetch.glsl"
#include "raytrace/pack.glsl"

layout(constant_id = CONSTANT_RAY_EFFECTS) const uint kRayEffects = 0u;
layout(constant_id = CONSTANT_ACCEL) const uint kAccel = ACCEL_BVH;

layout(local_size_x = 64) in; // before anything asks for gl_WorkGroupSize
layout(push_constant, scalar) uniform Push { RayPush push; };

FETCH_TABLE(rays, FETCH_RAYS, 22)
layout(set = 0, binding = 36, scalar) buffer Counters { RayCounters counters; };

FETCH_TABLE(hit_rays, FETCH_RAYS, 42)

#define wants_ray(effect) ((kRayEffects & (effect)) != 0u) // a macro for the reason that shade.glsl gives

// Work groups come in rows, since not every device takes many along x.
uint invocation() { return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

Ray read_ray(uint i) {
    uvec4 a = fetch_rays(kRayTexels * i), b = fetch_rays(kRayTexels * i + 1u), c = fetch_rays(kRayTexels * i + 2u);
    return Ray(uintBitsToFloat(a.xyz), uintBitsToFloat(a.w), uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.x), c.y, uintBitsToFloat(c.z), c.w);
}

// Which ray the i-th hit is of: hits lie together, however many rays went past everything.
uint ray_of_hit(uint i) {
    uvec4 four = fetch_hit_rays(i >> 2u);
    return (i & 2u) == 0u ? ((i & 1u) == 0u ? four.x : four.y) : ((i & 1u) == 0u ? four.z : four.w);
}

// One invocation bears witness for its work group: an atomic each would cost more than the work.
void count_done(uint count) {
    uint first = invocation();
    if (gl_LocalInvocationIndex == 0u && first < count) atomicAdd(counters.done, min(gl_WorkGroupSize.x, count - first));
}

#endif
