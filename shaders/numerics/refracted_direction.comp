// (i, n, eta) -> refracted_direction, whether it passes
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 7
#define KERNEL_RESULTS 4
#include "numerics/kernel.glsl"
#include "lib/refraction.glsl"

void kernel() {
    vec3 t;
    result(3, refracted_direction(argument3(0), argument3(3), argument(6), t) ? 1.0 : 0.0);
    result3(0, t);
}
