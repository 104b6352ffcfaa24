// (v, fallback) -> safe_normalize
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 6
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/vector.glsl"

void kernel() { result3(0, safe_normalize(argument3(0), argument3(3))); }
