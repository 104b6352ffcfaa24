// (offset, radius, sigma) -> filter_gaussian
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 4
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/filter.glsl"

void kernel() { result(0, filter_gaussian(vec2(argument(0), argument(1)), argument(2), argument(3))); }
