// (o, d, after) -> t, face, point, normal
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 7
#define KERNEL_RESULTS 8
#include "numerics/kernel.glsl"
#include "lib/ray_box.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3);
    uint face;
    float t = ray_cube(o, d, argument(6), face);
    result(0, t);
    result(1, float(face));
    result3(2, cube_point(o, d, t, face));
    result3(5, cube_normal(face));
}
