// (x) -> srgb_encode, the channel in the middle of three
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 1
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/color.glsl"

void kernel() { result(0, srgb_encode(vec3(0.0, argument(0), 1.0)).g); }
