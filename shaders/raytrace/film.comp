// The roots of a tile's ray trees as pixels of the frame. In: nodes. Out: an image of linear radiance, one sample a pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/effects.h"
#include "shared/rays.h"
#include "fetch.glsl"
#include "raytrace/tile.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { FilmPush push; };
FETCH_TABLE(tree, FETCH_RAYS, 28)
layout(set = 0, binding = 0, rgba32f) writeonly uniform image2D frame;

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (i >= push.count) return;
    uvec2 pixel = uvec2(push.tile_x, push.tile_y) + tile_pixel(i, uvec2(push.tile_size & 0xffffu, push.tile_size >> 16u));
    imageStore(frame, ivec2(pixel), vec4(uintBitsToFloat(fetch_tree(kRayNodeTexels * i).xyz), 1.0));
}
