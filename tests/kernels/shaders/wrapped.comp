// (duv) -> wrapped
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 2
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/mapping.glsl"

void kernel() {
    vec2 d = wrapped(vec2(argument(0), argument(1)));
    result(0, d.x);
    result(1, d.y);
}
