// (c, n) -> reflectance in the form with differences of c and g, Cook and Torrance 1982, sec. 4
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 2
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"

void kernel() {
    float c = argument(0), n = argument(1);
    float g = sqrt(n * n + c * c - 1.0);
    float s = (g - c) / (g + c), p = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    result(0, 0.5 * s * s * (1.0 + p * p));
}
