// (s, n) -> pow(1 - s, n), the wrong way that the bound of power_one_minus must catch
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 2
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"

void kernel() { result(0, pow(1.0 - argument(0), argument(1))); }
