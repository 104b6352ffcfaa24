// (o, d, v0, v1, v2, after) -> t, barycentrics, point, error
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 16
#define KERNEL_RESULTS 9
#include "numerics/kernel.glsl"
#include "lib/ray_triangle.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3), v0 = argument3(6), v1 = argument3(9), v2 = argument3(12), error;
    vec2 b;
    float t = ray_triangle(shear_of(d), o, v0, v1, v2, argument(15), b);
    vec3 p = triangle_point(v0, v1, v2, b, error);
    result(0, t);
    result(1, b.x);
    result(2, b.y);
    result3(3, p);
    result3(6, error);
}
