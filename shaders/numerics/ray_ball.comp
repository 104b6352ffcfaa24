// (o, d, after) -> t, point, error
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 7
#define KERNEL_RESULTS 7
#include "numerics/kernel.glsl"
#include "lib/ray_sphere.glsl"

void kernel() {
    vec3 o = argument3(0), d = argument3(3), error;
    float t = ray_ball(o, d, argument(6));
    vec3 p = ball_point(o, d, t, error);
    result(0, t);
    result3(1, p);
    result3(4, error);
}
