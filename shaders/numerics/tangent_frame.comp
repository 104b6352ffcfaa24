// (n, t, handedness) -> the two axes of tangent_frame
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 7
#define KERNEL_RESULTS 6
#include "numerics/kernel.glsl"
#include "lib/bump.glsl"

void kernel() {
    vec3 tt, bb;
    tangent_frame(argument3(0), argument3(3), argument(6), tt, bb);
    result3(0, tt);
    result3(3, bb);
}
