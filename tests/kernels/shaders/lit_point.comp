// (n, v, vector to the light, Ip, shininess, kd) -> light that arrives from one point light, composed as a shader composes it:
// finite where the light is at the point (LI-5), linear in Ip to the bit for powers of two (LI-7).
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 12
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/attenuation.glsl"
#include "lib/phong.glsl"
#include "lib/sum.glsl"
#include "lib/vector.glsl"

void kernel() {
    vec3 n = argument3(0);
    vec3 v = argument3(3);
    vec3 to_light = argument3(6);
    vec3 l = safe_normalize(to_light, n);
    float attenuation = attenuation_inverse_square(safe_length(to_light));
    vec3 arriving = argument(9) * attenuation * vec3(1.0, 0.5, 0.1);
    Sum3 sum = sum_start();
    sum_add(sum, arriving * (argument(11) * lambert(n, l)));
    sum_add(sum, arriving * phong_specular(n, l, v, argument(10)));
    result3(0, sum_result(sum));
}
