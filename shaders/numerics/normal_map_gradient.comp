// (texel, t, b, scale) -> normal_map_gradient
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 10
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/bump.glsl"

void kernel() { result3(0, normal_map_gradient(argument3(0), argument(9), argument3(3), argument3(6))); }
