// (picture, u, v, lod) -> height_gradient
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define KERNEL_ARGUMENTS 4
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "numerics/texel_kernel.glsl"

void kernel() {
    vec2 slopes = height_gradient(picture(argument(0)), argument2(1), argument(3));
    result(0, slopes.x);
    result(1, slopes.y);
}
