// (picture, u, v, derivatives of uv over x, over y) -> sample_anisotropic
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define KERNEL_ARGUMENTS 7
#define KERNEL_RESULTS 4
#include "numerics/kernel.glsl"
#include "numerics/texel_kernel.glsl"

void kernel() { result4(sample_anisotropic(picture(argument(0)), argument2(1), argument2(3), argument2(5))); }
