// (x, y) -> sum_upwards
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 2
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/exact.glsl"

void kernel() { result(0, sum_upwards(argument(0), argument(1))); }
