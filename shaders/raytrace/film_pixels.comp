// The roots of a tile's ray trees as 8-bit pixels, where one frame is all there is: what film.comp and display.comp do one after the other, without
// the image between them (512x512 on lavapipe: 10 ms for the two, 5.5 here). In: nodes. Out: 8-bit sRGB, and a census of what was linear.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/effects.h"
#include "shared/rays.h"
#include "fetch.glsl"
#include "display/encoded.glsl"
#include "raytrace/tile.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { PixelsPush push; };
FETCH_TABLE(tree, FETCH_RAYS, 28)
layout(set = 0, binding = 1, scalar) writeonly buffer Pixels { uint pixels[]; };
layout(set = 0, binding = 2, scalar) buffer CensusBlock { Census census; };

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (i >= push.count) return;
    if (gl_LocalInvocationIndex == 0u) atomicAdd(census.visited, min(gl_WorkGroupSize.x, push.count - i));
    uvec2 pixel = uvec2(push.tile_x, push.tile_y) + tile_pixel(i, uvec2(push.tile_size & 0xffffu, push.tile_size >> 16u)) - push.offset;
    vec3 radiance = uintBitsToFloat(fetch_tree(kRayNodeTexels * i).xyz);
    if (non_finite(vec4(radiance, 1.0))) atomicAdd(census.non_finite, 1u);
    pixels[pixel.y * push.width + pixel.x] = encoded(radiance * push.gain);
}
