// (d, d0) -> attenuation_linear
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 2
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/attenuation.glsl"

void kernel() { result(0, attenuation_linear(argument(0), argument(1))); }
