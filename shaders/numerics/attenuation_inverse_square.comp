// (d) -> attenuation_inverse_square
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 1
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/attenuation.glsl"

void kernel() { result(0, attenuation_inverse_square(argument(0))); }
