// (o, d, v0, v1, v2, gap, tilt) -> t, 1 if a ray that leaves the triangle on the side of the gap meets a second one, shifted by the gap
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 21
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/ray_triangle.glsl"
#include "lib/vector.glsl"

void kernel() {
    vec3 o = argument3(0), v0 = argument3(6), v1 = argument3(9), v2 = argument3(12), gap = argument3(15), error;
    vec2 b;
    float t = ray_triangle(shear_of(argument3(3)), o, v0, v1, v2, 0.0, b);
    vec3 p = triangle_point(v0, v1, v2, b, error), n = safe_normalize(cross(v1 - v0, v2 - v0), vec3(0.0));
    n = dot(n, gap) < 0.0 ? -n : n;
    vec3 w = fast_normalize(n + argument3(18));
    float next = ray_triangle(shear_of(w), offset_origin(p, error, n, w), v0 + gap, v1 + gap, v2 + gap, 0.0, b);
    result(0, t);
    result(1, next < kNoHit ? 1.0 : 0.0);
}
