// (key: four integers below 2^24) -> random_unit4
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 4
#define KERNEL_RESULTS 4
#include "numerics/kernel.glsl"
#include "lib/random.glsl"

void kernel() {
    vec4 xi = random_unit4(uvec4(uint(argument(0)), uint(argument(1)), uint(argument(2)), uint(argument(3))));
    result3(0, xi.xyz);
    result(3, xi.w);
}
