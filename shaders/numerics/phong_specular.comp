// (n, l, v, shininess) -> phong_specular
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 10
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/phong.glsl"

void kernel() { result(0, phong_specular(argument3(0), argument3(3), argument3(6), argument(9))); }
