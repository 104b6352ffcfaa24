// (n, geometric normal, v) -> keep_facing
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 9
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/bump.glsl"

void kernel() { result3(0, keep_facing(argument3(0), argument3(3), argument3(6))); }
