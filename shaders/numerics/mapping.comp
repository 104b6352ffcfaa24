// (p) -> map_spherical, map_cylindrical, map_planar
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 6
#include "numerics/kernel.glsl"
#include "lib/mapping.glsl"

void kernel() {
    vec3 p = argument3(0);
    vec2 maps[3] = vec2[3](map_spherical(p), map_cylindrical(p), map_planar(p));
    for (uint i = 0; i < 6; ++i) result(i, maps[i / 2][i % 2]);
}
