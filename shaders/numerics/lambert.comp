// (n, l) -> lambert
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 6
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/phong.glsl"

void kernel() { result(0, lambert(argument3(0), argument3(3))); }
