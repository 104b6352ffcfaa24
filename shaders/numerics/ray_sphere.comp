// (o, d, c, r, after) -> t, point, normal, error
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 11
#define KERNEL_RESULTS 10
#include "numerics/kernel.glsl"
#include "lib/ray_sphere.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3), c = argument3(6), n, error;
    float r = argument(9), t = ray_sphere(o, d, c, r, argument(10));
    vec3 p = sphere_point(o, d, t, c, r, n, error);
    result(0, t);
    result3(1, p);
    result3(4, n);
    result3(7, error);
}
