// Linear radiance to 8-bit sRGB pixels: exposure, clamp, encoding. Counts what is not finite before the clamp, which would hide it.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/layouts.h"
#include "display/encoded.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { DisplayPush push; };
layout(set = 0, binding = 0) uniform texture2D radiance;
layout(set = 0, binding = 1, scalar) writeonly buffer Pixels { uvec4 pixels[]; }; // four to an invocation: 11 ms for 19 on lavapipe, 1280x720
layout(set = 0, binding = 2, scalar) buffer CensusBlock { Census census; };

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
    uint first = 4u * i, count = push.size.x * push.size.y;
    if (first >= count) return;
    // One invocation bears witness for its work group: an atomic a pixel would cost more than the display.
    if (gl_LocalInvocationIndex == 0u) atomicAdd(census.visited, min(4u * gl_WorkGroupSize.x, count - first));
    uvec2 at = uvec2(first % push.size.x, first / push.size.x);
    uvec4 four;
    uint bad = 0u;
    for (uint k = 0u; k < 4u; ++k) {
        vec4 c = texelFetch(radiance, ivec2(push.offset + at), 0);
        bad += uint(first + k < count && non_finite(c));
        four[k] = encoded(c.rgb * push.gain);
        ++at.x;
        bool next = at.x == push.size.x;
        at = next ? uvec2(0u, min(at.y + 1u, push.size.y - 1u)) : at;
    }
    if (bad != 0u) atomicAdd(census.non_finite, bad);
    pixels[i] = four;
}
