// Adds a frame, times its weight, to the running sum: supersampling by shifted frames, and lights in bounded pieces.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/layouts.h"

layout(local_size_x = 16, local_size_y = 4) in;
layout(push_constant, scalar) uniform Push { AccumulatePush push; };
layout(set = 0, binding = 0, rgba32f) readonly uniform image2D frame;
layout(set = 0, binding = 1, rgba32f) uniform image2D sum;

void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    if (at.x >= push.size.x || at.y >= push.size.y) return;
    vec4 before = push.mode == ACCUMULATE_FIRST ? vec4(0.0) : imageLoad(sum, ivec2(at));
    vec4 added = imageLoad(frame, ivec2(at));
    if (push.mode == ACCUMULATE_MEAN) added -= before;
    imageStore(sum, ivec2(at), before + push.weight * added);
}
