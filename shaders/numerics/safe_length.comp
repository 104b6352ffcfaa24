// (v) -> safe_length
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/vector.glsl"

void kernel() { result(0, safe_length(argument3(0))); }
