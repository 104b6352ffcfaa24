// (s, n) -> power_one_minus
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 2
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/phong.glsl"

void kernel() { result(0, power_one_minus(argument(0), argument(1))); }
