// (c, n) -> fresnel
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 2
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/fresnel.glsl"

void kernel() { result(0, fresnel(argument(0), argument(1))); }
