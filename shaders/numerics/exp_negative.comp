// (x) -> exp_negative
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 1
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/power.glsl"

void kernel() { result(0, exp_negative(argument(0))); }
