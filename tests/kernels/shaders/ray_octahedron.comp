// (o, d, vertices +x -x +y -y +z -z of an octahedron) -> number of faces hit, nearest t
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 24
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/ray_triangle.glsl"

void kernel() {
    RayShear shear = shear_of(argument3(3));
    float nearest = kNoHit, faces = 0.0;
    uint tried = 0;
    for (uint i = 0; i < 8; ++i, ++tried) {
        vec3 x = argument3(6 + 3 * (i & 1)), y = argument3(12 + 3 * (i >> 1 & 1)), z = argument3(18 + 3 * (i >> 2));
        vec2 b;
        float t = ray_triangle(shear, argument3(0), x, y, z, 0.0, b);
        faces += t < kNoHit ? 1.0 : 0.0;
        nearest = min(nearest, t);
    }
    finished = tried == 8;
    result(0, faces);
    result(1, nearest);
}
