// Eye rays of a tile, one a pixel, or through listed points of the image, where they are wanted before they are traced: trace.comp can make
// those of a tile by itself. In: the camera. Out: the first generation of rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/effects.h"
#include "shared/rays.h"
#include "fetch.glsl"
#include "raytrace/pack.glsl"

layout(constant_id = CONSTANT_RAY_EFFECTS) const uint kRayEffects = 0u;
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { EyePush push; };
FETCH_TABLE(eye_points, FETCH_EYE_POINTS, 24)
layout(set = 0, binding = 32, scalar) writeonly buffer NextRays { uvec4 next_rays[]; };
layout(set = 0, binding = 36, scalar) buffer Counters { RayCounters counters; };
layout(set = 0, binding = 40, scalar) writeonly buffer NextMedia { uvec4 next_media[]; };

#define wants_ray(effect) ((kRayEffects & (effect)) != 0u) // a macro for the reason that shade.glsl gives

#define camera push
#include "raytrace/eye.glsl"

// As tile_point().
vec2 image_point(uint i, out uint key) {
    if (!wants_ray(RAY_LIST)) return tile_point(i, key);
    uvec4 p = fetch_eye_points(push.first + i);
    key = p.z;
    return uintBitsToFloat(p.xy);
}

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (gl_LocalInvocationIndex == 0u && i < push.count) atomicAdd(counters.done, min(gl_WorkGroupSize.x, push.count - i));
    if (i >= push.count) return;
    uint key;
    vec2 at = image_point(i, key);
    uvec4 a, b, c;
    pack_ray(eye_ray(at, key), a, b, c);
    next_rays[kRayTexels * i] = a, next_rays[kRayTexels * i + 1u] = b, next_rays[kRayTexels * i + 2u] = c;
    if (wants_ray(RAY_REFRACTED)) next_media[i] = push.media;
}
