// (d) -> equirect_uv
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/environment.glsl"

void kernel() {
    vec2 uv = equirect_uv(argument3(0));
    result(0, uv.x);
    result(1, uv.y);
}
