// (v) -> fast_normalize
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/vector.glsl"

void kernel() { result3(0, fast_normalize(argument3(0))); }
