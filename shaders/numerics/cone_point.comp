// (p, r0, r1, part) -> cone_point, and cone_normal there
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 6
#define KERNEL_RESULTS 6
#include "numerics/kernel.glsl"
#include "lib/ray_cone.glsl"

void kernel() {
    vec3 p = cone_point(argument3(0), argument(3), argument(4), uint(argument(5)));
    result3(0, p);
    result3(3, cone_normal(p, argument(3), argument(4), uint(argument(5))));
}
