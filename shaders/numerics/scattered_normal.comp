// (n, slope, xi) -> scattered_normal
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 6
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/scatter.glsl"

void kernel() { result3(0, scattered_normal(argument3(0), argument(3), vec2(argument(4), argument(5)))); }
