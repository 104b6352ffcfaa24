// One walk, by the structure that was asked for; and how walks that spent their steps are put down and taken up in a later dispatch.
#ifndef LIGHTBENCH_RAYTRACE_WALKS_GLSL
#define LIGHTBENCH_RAYTRACE_WALKS_GLSL

#include "raytrace/walk_bvh.glsl"
#include "raytrace/walk_grid.glsl"
#include "raytrace/walk_none.glsl"
#include "raytrace/walk_octree.glsl"
#include "raytrace/walk_sphere_bvh.glsl"

// kRayWalkWords + kStack words each.
layout(set = 0, binding = 37, scalar) buffer Walks { uint walk_words[]; };

// A lane that has nothing to look for goes along in a packet, and does not even start by itself.
Walk walk_start(bool asked) { return Walk(asked || wants_ray(RAY_PACKETS) ? 0u : kNothing, 1u, 0u, 0u); }

// hit.t is the limit: what lies beyond is not found. True if the walk has ended.
bool walk(inout RayHit hit, bool any, inout Walk w) {
    if (kAccel == ACCEL_BVH) {
        if (wants_ray(RAY_PACKETS)) return walk_wide(hit, any, w);
        return walk_narrow(hit, any, w);
    }
    if (kAccel == ACCEL_SPHERE_BVH) return walk_sphere_bvh(hit, any, w);
    if (kAccel == ACCEL_GRID) return walk_grid(hit, any, w);
    if (kAccel == ACCEL_OCTREE) return walk_octree(hit, any, w);
    return walk_none(hit, any, w);
}

void take_up_walk(uint slot, inout Walk w, inout RayHit hit) {
    uint at = slot * (kRayWalkWords + kStack);
    w = Walk(walk_words[at], walk_words[at + 1u], walk_words[at + 2u], walk_words[at + 3u]);
    hit = RayHit(uintBitsToFloat(walk_words[at + 4u]), walk_words[at + 5u], uintBitsToFloat(walk_words[at + 6u]),
                 uintBitsToFloat(walk_words[at + 7u]));
    hit_number = number_of(hit.ref);
    if (wants_ray(RAY_REFRACTED)) hit_t = uintBitsToFloat(walk_words[at + 13u]);
    for (uint i = 0u; i < (w.node == kNothing ? 0u : w.top); ++i) stack[i] = walk_words[at + kRayWalkWords + i];
}

void put_down_walk(uint slot, Walk w, RayHit hit) {
    uint at = slot * (kRayWalkWords + kStack);
    walk_words[at] = w.node, walk_words[at + 1u] = w.top, walk_words[at + 2u] = w.a, walk_words[at + 3u] = w.b;
    walk_words[at + 4u] = floatBitsToUint(hit.t), walk_words[at + 5u] = hit.ref;
    walk_words[at + 6u] = floatBitsToUint(hit.b1), walk_words[at + 7u] = floatBitsToUint(hit.b2);
    if (wants_ray(RAY_REFRACTED)) walk_words[at + 13u] = floatBitsToUint(hit_t);
    for (uint i = 0u; i < (w.node == kNothing ? 0u : w.top); ++i) walk_words[at + kRayWalkWords + i] = stack[i];
}

// What a shadow ray has passed so far.
void take_up_light(uint slot, out vec3 clear) {
    uint at = slot * (kRayWalkWords + kStack) + 8u;
    clear = uintBitsToFloat(uvec3(walk_words[at], walk_words[at + 1u], walk_words[at + 2u]));
    set_after(uintBitsToFloat(walk_words[at + 4u]), walk_words[at + 3u]);
}

void put_down_light(uint slot, vec3 clear) {
    uint at = slot * (kRayWalkWords + kStack) + 8u;
    uvec3 words = floatBitsToUint(clear);
    walk_words[at] = words.x, walk_words[at + 1u] = words.y, walk_words[at + 2u] = words.z;
    walk_words[at + 3u] = ray.after_number, walk_words[at + 4u] = floatBitsToUint(ray.after);
}

void count_unfinished(bool done) {
    if (!done) atomicAdd(counters.unfinished, 1u);
}

#endif
