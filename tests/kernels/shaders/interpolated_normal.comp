// (normal, normal, face normal, weight) -> the normal between the first two
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 10
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/vector.glsl"

void kernel() { result3(0, safe_normalize(mix(argument3(0), argument3(3), argument(9)), argument3(6))); }
