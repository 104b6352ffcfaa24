// (d) -> cube_face, uv
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/environment.glsl"

void kernel() {
    vec2 uv;
    result(0, float(cube_face(argument3(0), uv)));
    result(1, uv.x);
    result(2, uv.y);
}
