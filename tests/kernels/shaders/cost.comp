// One function of the library in a loop, chosen by a constant: what a call costs on this device, less the loop with function 0.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/attenuation.glsl"
#include "lib/color.glsl"
#include "lib/cook_torrance.glsl"
#include "lib/fresnel.glsl"
#include "lib/phong.glsl"
#include "lib/spot.glsl"
#include "lib/sum.glsl"
#include "lib/vector.glsl"

layout(constant_id = 0) const uint kFunction = 0;
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint calls; }; // an invocation: bounded, drivers may end loops silently
layout(set = 0, binding = 0) readonly buffer Arguments { float argument[]; }; // 10 floats: n, l, v, shininess
layout(set = 0, binding = 1) buffer Results { float results[]; };             // a sum that keeps the calls alive, the number of calls

float call(vec3 n, vec3 l, vec3 v, float shininess, inout Sum3 sum) {
    vec3 r = 2.0 * dot(n, l) * n - l;
    switch (kFunction) {
    case 1: return phong_specular(n, l, v, shininess);
    case 2: return pow(max(dot(r, v), 0.0), shininess);
    case 3: return power_one_minus(0.5 * abs(v.x), shininess);
    case 4: return pow(1.0 - 0.5 * abs(v.x), shininess);
    case 5: return lambert(n, l);
    case 6: return dot(safe_normalize(n, v), vec3(1.0));
    case 7: return dot(fast_normalize(n), vec3(1.0));
    case 8: return safe_length(n);
    case 9: return length(n);
    case 10: return attenuation_linear(abs(n.x), 1.0);
    case 11: return attenuation_inverse_square(abs(n.x));
    case 12: return spot_falloff(n.x, 0.1, 0.3);
    case 13: sum_add(sum, n); return 0.0;
    case 14: sum.total += n; return 0.0;
    case 15: return dot(srgb_encode(n), vec3(1.0));
    case 16: return float(quantize8(n.x));
    case 17: return dot(normalize(n), vec3(1.0));
    case 18: return dot(cook_torrance_gaussian(n, l, v, 0.01 * shininess, shininess, 1.5 + abs(v)), vec3(1.0));
    case 19: return dot(cook_torrance_beckmann(n, l, v, 0.01 * shininess, shininess, 1.5 + abs(v)), vec3(1.0));
    case 20: return dot(fresnel_dense(abs(n.x), 1.5 + abs(v)), vec3(1.0));
    case 21: return dot(fresnel(abs(n.x), 0.5 + abs(v)), vec3(1.0));
    }
    return n.x + n.y + n.z + l.x + v.x;
}

void main() {
    uint at = gl_GlobalInvocationID.x * 10;
    vec3 n = vec3(argument[at], argument[at + 1], argument[at + 2]), l = vec3(argument[at + 3], argument[at + 4], argument[at + 5]);
    vec3 v = vec3(argument[at + 6], argument[at + 7], argument[at + 8]);
    Sum3 sum = sum_start();
    float total = 0.0;
    uint done = 0;
    for (uint i = 0; i < calls; ++i, ++done) {
        vec3 step = vec3(float(i) * 1e-6);
        total += call(n + step, l - step, v + step, argument[9], sum);
    }
    results[gl_GlobalInvocationID.x * 2] = total + dot(sum_result(sum), vec3(1.0));
    results[gl_GlobalInvocationID.x * 2 + 1] = float(done);
}
