// (i, n, eta) -> i after 1000 surfaces: into the glass and out again in turn
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 7
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/refraction.glsl"

void kernel() {
    vec3 d = argument3(0), n = argument3(3);
    float eta = argument(6);
    int rounds = 0;
    for (; rounds < 500; ++rounds) {
        vec3 inside, outside;
        refracted_direction(d, n, eta, inside);
        d = refracted_direction(inside, n, 1.0 / eta, outside) ? outside : d;
    }
    finished = rounds == 500;
    result3(0, d);
}
