// (i) -> i after three mirrors at right angles
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/refraction.glsl"

void kernel() {
    const vec3 a = vec3(1.0, 1.0, 1.0), b = vec3(1.0, -1.0, 0.0), c = vec3(1.0, 1.0, -2.0); // at right angles, not unit
    result3(0, mirror_direction(mirror_direction(mirror_direction(argument3(0), a), b), c));
}
