// (o, d, v0, v1, v2, 4 directions) -> t, how many rays that leave the point to either side meet the triangle again
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 27
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/ray_triangle.glsl"
#include "lib/vector.glsl"

void kernel() {
    vec3 o = argument3(0), v0 = argument3(6), v1 = argument3(9), v2 = argument3(12), error;
    vec2 b;
    float t = ray_triangle(shear_of(argument3(3)), o, v0, v1, v2, 0.0, b), again = 0.0;
    vec3 p = triangle_point(v0, v1, v2, b, error), n = safe_normalize(cross(v1 - v0, v2 - v0), vec3(0.0));
    for (uint i = 0; i < 4; ++i) {
        vec3 w = argument3(15 + 3 * i);
        vec2 at;
        again += ray_triangle(shear_of(w), offset_origin(p, error, n, w), v0, v1, v2, 0.0, at) < kNoHit ? 1.0 : 0.0;
    }
    result(0, t);
    result(1, again);
}
