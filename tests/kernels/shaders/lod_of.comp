// (picture, derivatives of uv over x, over y) -> lod_of
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define KERNEL_ARGUMENTS 5
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "numerics/texel_kernel.glsl"

void kernel() { result(0, lod_of(picture(argument(0)), argument2(1), argument2(3))); }
