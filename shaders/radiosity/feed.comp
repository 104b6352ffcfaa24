// What one light without area sends to each element directly (S3 to S5, S15), as the first shot of all. One invocation an element. In: elements,
// the structure over them, lights. Out: irradiance is added.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define LIGHTBENCH_TRACED
#define LIGHTBENCH_ANY_HIT true
#include "raytrace/walks.glsl"
#include "radiosity/receivers.glsl"
#include "shade.glsl"

layout(set = 0, binding = 50, scalar) buffer Irradiance { vec4 irradiance[]; };

vec3 visibility(uint light) { return vec3(1.0); } // what is found out here

void main() {
    uint i = invocation(), k = min(i, push.count - 1u);
    count_done(push.count);
    bool live = i < push.count;
    Receiver r = read_receiver(k);
    Light light = read_light(push.first_light);
    Arrival a = arrive(light, r.center);
    vec3 way = a.l;
    float limit = kNoHit;
    if (wants(EFFECT_POINT_LIGHT | EFFECT_SPOT_LIGHT)) {
        vec3 to_light = light.position - r.center;
        float distance = length(to_light);
        // It ends before the light by the error of both ends (SH-3): 2^-20 = 16 u of the way.
        if (light.type != kLightDirectional) way = to_light / max(distance, kLeastNormal), limit = distance * 0.99999905;
    }
    float cosine = dot(r.normal, way);
    bool asked = live && cosine > 0.0 && r.covered == 0u;
    start_ray(Ray(r.center, 0.0, way, kNothing, 0.0, 0u, 0.0, 0u));
    RayHit hit = RayHit(asked ? limit : -1.0, kNothing, 0.0, 0.0);
    Walk w = walk_start(asked);
    bool done = walk(hit, true, w);
    if (!live) return;
    // Ip is irradiance over pi (S1).
    if (asked && hit.ref == kNothing) irradiance[i] += vec4(3.14159265 * cosine * a.intensity, 0.0);
    count_unfinished(done);
}
