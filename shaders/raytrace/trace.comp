// The nearest hit of every ray of a generation. In: rays, the primitives and a structure over them. Out: the hits, one after the other, and
// which rays they are of; the finished nodes of rays that leave the scene. With RAY_EYE the rays are a tile's eye rays, made here: those that
// hit something are written, the others nobody asks for.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#define LIGHTBENCH_TRACED
#include "raytrace/walks.glsl"
#include "environment.glsl"

layout(set = 0, binding = 32, scalar) writeonly buffer Hits { uvec4 hits[]; };
layout(set = 0, binding = 33, scalar) writeonly buffer HitRays { uint hit_rays_out[]; };
layout(set = 0, binding = 34, scalar) writeonly buffer Tree { uvec4 node_words[]; };
layout(set = 0, binding = 38, scalar) uniform Camera { EyePush camera; };
layout(set = 0, binding = 39, scalar) writeonly buffer EyeRays { uvec4 eye_rays[]; };
layout(set = 0, binding = 40, scalar) writeonly buffer EyeMedia { uvec4 eye_media[]; };
#include "raytrace/eye.glsl"

vec3 visibility(uint light) { return vec3(1.0); } // no light is summed here

// Radiance from where no object is.
vec3 background_radiance() {
    if (wants(EFFECT_BACKGROUND_MAP)) return environment_radiance(ray.d, push.spread);
    return push.background;
}

// One atomic for the hits of a SIMD group.
uint place_of_hit(bool found) {
    uint one = uint(found), before = subgroupExclusiveAdd(one), all = subgroupAdd(one), first = 0u;
    if (subgroupElect() && all > 0u) first = atomicAdd(counters.hits, all);
    return subgroupBroadcastFirst(first) + before;
}

Ray ray_of(uint i) {
    if (!wants_ray(RAY_EYE)) return read_ray(i);
    uint key;
    vec2 at = tile_point(i, key);
    return eye_ray(at, key);
}

void keep(uint i, Ray r) {
    if (!wants_ray(RAY_EYE)) return;
    pack_ray(r, eye_rays[kRayTexels * i], eye_rays[kRayTexels * i + 1u], eye_rays[kRayTexels * i + 2u]);
    if (wants_ray(RAY_REFRACTED)) eye_media[i] = camera.media;
}

void main() {
    uint i = invocation();
    count_done(push.count);
    // SIMD groups stay whole: lanes without a ray go along with one that nothing can be hit by.
    bool live = i < push.count;
    Ray traced = ray_of(min(i, push.count - 1u));
    start_ray(traced);
    RayHit hit = RayHit(live ? kNoHit : -1.0, kNothing, 0.0, 0.0);
    Walk w = walk_start(live);
    if (wants_ray(RAY_RESUME) && push.resume != 0u) take_up_walk(min(i, push.count - 1u), w, hit);
    bool done = walk(hit, false, w);
    bool ends = live && (!wants_ray(RAY_RESUME) || push.resume == kCollect); // put down, hits are handed on once all walks have ended
    bool found = ends && hit.ref != kNothing;
    uint at = place_of_hit(found);
    if (found) {
        hits[at] = uvec4(floatBitsToUint(at_distance(hit).t), hit.ref, floatBitsToUint(vec2(hit.b1, hit.b2)));
        hit_rays_out[at] = i;
        keep(i, traced);
    }
    if (ends && !found) node_words[kRayNodeTexels * (push.first + i)] = uvec4(floatBitsToUint(background_radiance()), 0u);
    if (wants_ray(RAY_RESUME) && live) put_down_walk(i, w, hit);
    count_unfinished(done);
    add_counts();
}
