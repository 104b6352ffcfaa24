// (o, d, r0, r1, capped, after) -> ray_cone, part
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 10
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/ray_cone.glsl"

void kernel() {
    uint part;
    result(0, ray_cone(argument3(0), argument3(3), argument(6), argument(7), argument(8) != 0.0, argument(9), part));
    result(1, float(part));
}
