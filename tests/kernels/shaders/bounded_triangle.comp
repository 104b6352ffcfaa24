// (o, d, v0, v1, v2) -> t of the triangle, entry into its box up to that t, and up to anywhere
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 15
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/ray_box.glsl"
#include "lib/ray_triangle.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3), v0 = argument3(6), v1 = argument3(9), v2 = argument3(12);
    vec3 lo = min(v0, min(v1, v2)), hi = max(v0, max(v1, v2)), m = max(abs(lo), abs(hi));
    vec2 b;
    float t = ray_triangle(shear_of(d), o, v0, v1, v2, 0.0, b);
    result(0, t);
    BoxRay ray = box_ray(o, d, max(m.x, max(m.y, m.z)));
    result(1, slab(ray, lo, hi, t));
    result(2, slab(ray, lo, hi, kNoHit));
}
