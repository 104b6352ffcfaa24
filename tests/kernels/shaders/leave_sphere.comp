// (o, d, c, r, 4 directions) -> t, how many rays that leave the point outwards meet the sphere again, least cosine
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 22
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/ray_sphere.glsl"

// The directions are turned outwards.
void kernel() {
    vec3 o = argument3(0), d = argument3(3), c = argument3(6), n, error;
    float r = argument(9), t = ray_sphere(o, d, c, r, 0.0), again = 0.0, least = 1.0;
    vec3 p = sphere_point(o, d, t, c, r, n, error);
    for (uint i = 0; i < 4; ++i) {
        vec3 w = argument3(10 + 3 * i);
        w = dot(w, n) < 0.0 ? -w : w;
        least = min(least, dot(w, n));
        again += ray_sphere(offset_origin(p, error, n, w), w, c, r, 0.0) < kNoHit ? 1.0 : 0.0;
    }
    result(0, t);
    result(1, again);
    result(2, least);
}
