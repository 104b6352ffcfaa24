// (o, d, world_from_object, object_from_world by columns, 4 directions) -> as leave_sphere, for a transformed ball
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 42
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/ray_sphere.glsl"

mat4x3 matrix(uint at) { return mat4x3(argument3(at), argument3(at + 3), argument3(at + 6), argument3(at + 9)); }

void kernel() {
    mat4x3 out_of = matrix(6), into = matrix(18);
    vec3 o = into * vec4(argument3(0), 1.0), d = mat3(into) * argument3(3);
    float first = ray_ball(o, d, 0.0), again = 0.0, least = 1.0;
    vec3 error, q = ball_point(o, d, first, error), m = q;
    vec3 p = world_point(out_of, into, q, error), n = safe_normalize(m * mat3(into), vec3(0.0));
    for (uint i = 0; i < 4; ++i) {
        vec3 w = argument3(30 + 3 * i);
        w = dot(w, n) < 0.0 ? -w : w;
        least = min(least, dot(w, n));
        o = into * vec4(offset_origin(p, error, n, w), 1.0);
        d = mat3(into) * w;
        again += ray_ball(o, d, 0.0) < kNoHit ? 1.0 : 0.0;
    }
    result(0, first);
    result(1, again);
    result(2, least);
}
