// (uv, derivatives of uv over x, over y) -> checker
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 6
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/checker.glsl"

void kernel() { result(0, checker(vec2(argument(0), argument(1)), vec2(argument(2), argument(3)), vec2(argument(4), argument(5)))); }
