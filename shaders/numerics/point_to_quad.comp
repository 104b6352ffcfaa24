// (n, q0, q1, q2, q3) -> point_to_quad
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 15
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/form_factor.glsl"

void kernel() { result(0, point_to_quad(argument3(0), argument3(3), argument3(6), argument3(9), argument3(12), 0.0)); }
