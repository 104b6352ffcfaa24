// (t) -> sine_cosine
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 1
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/noise.glsl"

void kernel() {
    vec2 both = sine_cosine(argument(0));
    result(0, both.x);
    result(1, both.y);
}
