// (o, d, c, r) -> t
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 10
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/ray_sphere.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3), c = argument3(6);
    result(0, near_sphere(o, d, ray_sphere(o, d, c, argument(9), 0.0), c, argument(9)));
}
