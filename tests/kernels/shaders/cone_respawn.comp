// (o, d, r0, r1, w, offset, lean) -> t; the t of a ray that starts there, lifted off by offset, in the direction w or -w, away from the
// surface, or leaning towards its tangent plane
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 13
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/ray_cone.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3), w = argument3(8);
    float r0 = argument(6), r1 = argument(7);
    uint part;
    float t = ray_cone(o, d, r0, r1, true, 0.0, part);
    vec3 p = cone_point(o + t * d, r0, r1, part), n = fast_normalize(cone_normal(p, r0, r1, part));
    w = fast_normalize(w - argument(12) * dot(w, n) * n);
    w -= argument(12) * dot(w, n) * n; // again: of a short one the first time leaves mostly rounding
    result(0, t);
    result(1, ray_cone(p + argument(11) * n, dot(w, n) < 0.0 ? -w : w, r0, r1, true, 0.0, part));
}
