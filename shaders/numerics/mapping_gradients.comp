// (p) -> gradients of u and of v of the spherical, the cylindrical and the planar mapping
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 18
#include "numerics/kernel.glsl"
#include "lib/mapping.glsl"

void kernel() {
    vec3 p = argument3(0), du, dv;
    map_spherical_gradients(p, du, dv);
    result3(0, du);
    result3(3, dv);
    map_cylindrical_gradients(p, du, dv);
    result3(6, du);
    result3(9, dv);
    map_planar_gradients(p, du, dv);
    result3(12, du);
    result3(15, dv);
}
