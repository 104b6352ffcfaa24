// (i, n0, n1, n2) -> i after 999 mirrors: n0, n1, n2 in turn
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 12
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/refraction.glsl"

void kernel() {
    vec3 d = argument3(0);
    int rounds = 0;
    for (; rounds < 333; ++rounds)
        d = mirror_direction(mirror_direction(mirror_direction(d, argument3(3)), argument3(6)), argument3(9));
    finished = rounds == 333;
    result3(0, d);
}
