// (n, l, v, m, lobe, ior) -> cook_torrance_gaussian
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 14
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/cook_torrance.glsl"

void kernel() {
    result3(0, cook_torrance_gaussian(argument3(0), argument3(3), argument3(6), argument(9), argument(10), argument3(11)));
}
