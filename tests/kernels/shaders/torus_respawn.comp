// (o, d, m, w, offset, lean) -> t; p, the point there lifted off by offset; the t of the ray from p in the direction w or -w, away from the
// surface, or leaning towards its tangent plane
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 12
#define KERNEL_RESULTS 8
#include "numerics/kernel.glsl"
#include "lib/ray_torus.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3), w = argument3(7);
    float m = argument(6), t = ray_torus(o, d, m, 0.0);
    vec3 p = torus_point(o + t * d, m), n = torus_normal(p, m), q = p + argument(10) * n;
    w = fast_normalize(w - argument(11) * dot(w, n) * n);
    w -= argument(11) * dot(w, n) * n; // again: of a short one the first time leaves mostly rounding
    w = dot(w, n) < 0.0 ? -w : w;
    result(0, t);
    result3(1, q);
    result3(4, w);
    result(7, ray_torus(q, w, m, 0.0));
}
