// (p, m) -> torus_point, and torus_normal there
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 4
#define KERNEL_RESULTS 6
#include "numerics/kernel.glsl"
#include "lib/ray_torus.glsl"

void kernel() {
    vec3 p = torus_point(argument3(0), argument(3));
    result3(0, p);
    result3(3, torus_normal(p, argument(3)));
}
