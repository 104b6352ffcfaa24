// (p, error, n, d) -> origin
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 12
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/ray.glsl"

void kernel() { result3(0, offset_origin(argument3(0), argument3(3), argument3(6), argument3(9))); }
