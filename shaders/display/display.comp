// Linear radiance to 8-bit sRGB pixels: exposure, clamp, encoding. Counts what is not finite before the clamp, which would hide it.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/layouts.h"
#include "lib/color.glsl"

layout(local_size_x = 16, local_size_y = 4) in;
layout(push_constant, scalar) uniform Push { DisplayPush push; };
layout(set = 0, binding = 0) uniform texture2D radiance;
layout(set = 0, binding = 1, scalar) writeonly buffer Pixels { uint pixels[]; };
layout(set = 0, binding = 2, scalar) buffer CensusBlock { Census census; };

void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    // One invocation bears witness for its work group: an atomic a pixel would cost more than the display.
    if (gl_LocalInvocationIndex == 0u) {
        uvec2 inside = min(gl_WorkGroupSize.xy, push.size - at);
        atomicAdd(census.visited, inside.x * inside.y);
    }
    if (at.x >= push.size.x || at.y >= push.size.y) return;
    vec4 c = texelFetch(radiance, ivec2(push.offset + at), 0);
    if (non_finite(c)) atomicAdd(census.non_finite, 1u);
    vec3 encoded = srgb_encode(clamp(c.rgb * push.gain, 0.0, 1.0));
    pixels[at.y * push.size.x + at.x] = quantize8(encoded.r) | quantize8(encoded.g) << 8 | quantize8(encoded.b) << 16 | 0xff000000u;
}
