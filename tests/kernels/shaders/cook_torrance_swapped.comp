// (n, l, v, m, lobe, ior) -> the BRDF, factor over N.L, from l to v and from v to l; Gaussian, then Beckmann
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 14
#define KERNEL_RESULTS 4
#include "numerics/kernel.glsl"
#include "lib/cook_torrance.glsl"

void kernel() {
    vec3 n = argument3(0), l = argument3(3), v = argument3(6), ior = argument3(11);
    float m = argument(9), lobe = argument(10);
    result(0, cook_torrance_gaussian(n, l, v, m, lobe, ior).x / dot(n, l));
    result(1, cook_torrance_gaussian(n, v, l, m, lobe, ior).x / dot(n, v));
    result(2, cook_torrance_beckmann(n, l, v, m, lobe, ior).x / dot(n, l));
    result(3, cook_torrance_beckmann(n, v, l, m, lobe, ior).x / dot(n, v));
}
