// Counts the translucent fragments of each pixel that the opaque surfaces do not hide.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/layouts.h"
#include "raster/layers.glsl"

layout(early_fragment_tests) in;
layout(push_constant, scalar) uniform Push { ShadePush push; };
layout(set = 0, binding = 18, scalar) buffer Counts { uint counts[]; };

void main() {
    uvec2 at = uvec2(gl_FragCoord.xy) - uvec2(push.list_origin & 0xffffu, push.list_origin >> 16u);
    atomicAdd(counts[tile_pixel(at, push.list_width)], 1u);
}
