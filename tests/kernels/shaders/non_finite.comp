// (vec4) -> non_finite, is_finite of the first
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 4
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/color.glsl"

void kernel() {
    result(0, non_finite(vec4(argument3(0), argument(3))) ? 1.0 : 0.0);
    result(1, is_finite(argument(0)) ? 1.0 : 0.0);
}
