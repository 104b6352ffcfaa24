// (high, low, threshold) -> 1 if the contrast is above the threshold, else 0
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/contrast.glsl"

void kernel() { result(0, contrast_exceeds(argument(0), argument(1), argument(2)) ? 1.0 : 0.0); }
