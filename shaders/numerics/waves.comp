// (q) -> waves
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 4
#include "numerics/kernel.glsl"
#include "lib/noise.glsl"

void kernel() {
    vec4 wave = waves(argument3(0));
    result3(0, wave.xyz);
    result(3, wave.w);
}
