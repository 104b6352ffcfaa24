// (q) -> gradient_noise
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 4
#include "numerics/kernel.glsl"
#include "lib/noise.glsl"

void kernel() {
    vec4 noise = gradient_noise(argument3(0));
    result3(0, noise.xyz);
    result(3, noise.w);
}
