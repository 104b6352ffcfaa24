// (o, d, m, after) -> ray_torus
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 8
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/ray_torus.glsl"

void kernel() { result(0, ray_torus(argument3(0), argument3(3), argument(6), argument(7))); }
