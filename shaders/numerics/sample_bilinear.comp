// (picture, u, v, level) -> sample_bilinear
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define KERNEL_ARGUMENTS 4
#define KERNEL_RESULTS 4
#include "numerics/kernel.glsl"
#include "numerics/texel_kernel.glsl"

void kernel() { result4(sample_bilinear(picture(argument(0)), argument2(1), uint(argument(3)))); }
