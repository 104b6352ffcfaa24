// (o, d, c, r) -> t of the sphere, entry into its box up to that t
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 10
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/ray_box.glsl"
#include "lib/ray_sphere.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3), c = argument3(6);
    float r = argument(9);
    vec3 lo = c - r, hi = c + r, m = max(abs(lo), abs(hi));
    float t = ray_sphere(o, d, c, r, 0.0);
    result(0, t);
    result(1, slab(box_ray(o, d, max(m.x, max(m.y, m.z))), lo, hi, t));
}
