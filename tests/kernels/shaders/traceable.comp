// (o, d) -> 1 or 0
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 6
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/ray.glsl"

void kernel() { result(0, traceable(argument3(0), argument3(3)) ? 1.0 : 0.0); }
