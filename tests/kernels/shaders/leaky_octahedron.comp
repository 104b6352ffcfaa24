// As ray_octahedron, with a triangle test that is not watertight: Moeller, Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 24
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/ray.glsl"

float leaky_triangle(vec3 o, vec3 d, vec3 v0, vec3 v1, vec3 v2) {
    vec3 u = v1 - v0, v = v2 - v0, w = o - v0, p = cross(d, v), q = cross(w, u);
    float inverse = 1.0 / dot(u, p), a = dot(w, p) * inverse, b = dot(d, q) * inverse, t = dot(v, q) * inverse;
    return a >= 0.0 && b >= 0.0 && a + b <= 1.0 && t > 0.0 ? t : kNoHit;
}

void kernel() {
    float nearest = kNoHit, faces = 0.0;
    uint tried = 0;
    for (uint i = 0; i < 8; ++i, ++tried) {
        vec3 x = argument3(6 + 3 * (i & 1)), y = argument3(12 + 3 * (i >> 1 & 1)), z = argument3(18 + 3 * (i >> 2));
        float t = leaky_triangle(argument3(0), argument3(3), x, y, z);
        faces += t < kNoHit ? 1.0 : 0.0;
        nearest = min(nearest, t);
    }
    finished = tried == 8;
    result(0, faces);
    result(1, nearest);
}
