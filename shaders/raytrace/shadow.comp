// How much of each light reaches each point (S15): one invocation a point and a light, one layer of work groups a light. In: points,
// lights, primitives. Out: visibility per channel; 1 where the light is not asked for, since its terms are 0 there.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define LIGHTBENCH_TRACED
#include "raytrace/walks.glsl"
#include "raytrace/points.glsl"
#include "shade.glsl"

layout(set = 0, binding = 33, scalar) writeonly buffer Visibility { vec4 visible[]; };

vec3 visibility(uint light) { return vec3(1.0); } // what is found out here

// From the point to the light. Nothing is asked of a light behind the surface or its shading normal, or one that sends nothing here.
bool shadow_ray(uint i, Light light, out Ray r, out float limit) {
    RayPoint p = read_point(i);
    Surface s = Surface(p.position, p.normal, p.normal);
    Arrival a = arrive(light, p.position);
    vec3 way = a.l;
    limit = kNoHit;
    if (wants(EFFECT_POINT_LIGHT | EFFECT_SPOT_LIGHT)) {
        // Aimed anew from where the ray starts. It ends before the light by the error of both ends (SH-3): 2^-20 = 16 u of the way.
        vec3 to_light = light.position - p.origin;
        float distance = length(to_light);
        if (light.type != kLightDirectional) way = to_light / max(distance, kLeastNormal), limit = distance * 0.99999905;
    }
    r = Ray(p.origin, 0.0, way, kNothing, 0.0, 0u, 0.0, 0u);
    bool sends = a.intensity.x > 0.0 || a.intensity.y > 0.0 || a.intensity.z > 0.0;
    return sends && dot(p.normal, a.l) > 0.0 && dot(p.face, a.l) > 0.0;
}

void main() {
    uint i = invocation(), layer = gl_WorkGroupID.z;
    if (layer == 0u) count_done(push.count);
    bool live = i < push.count;
    if (!wants_ray(RAY_PACKETS) && !live) return;
    Ray r;
    float limit;
    bool asked = shadow_ray(min(i, push.count - 1u), read_light(push.first_light + push.layer + layer), r, limit);
    asked = asked && live;
    start_ray(r);
    RayHit hit = RayHit(asked ? limit : -1.0, kNothing, 0.0, 0.0);
    Walk w = walk_start(asked);
    if (wants_ray(RAY_RESUME) && push.resume != 0u) take_up_walk(min(i, push.count - 1u), w, hit); // one light a dispatch
    bool done = walk(hit, true, w);
    if (live) {
        visible[(push.layer + layer) * push.count + i] = vec4(vec3(hit.ref == kNothing ? 1.0 : 0.0), 0.0);
        if (wants_ray(RAY_RESUME)) put_down_walk(i, w, hit);
        count_unfinished(done);
    }
    if (wants_ray(RAY_COUNT)) atomicAdd(counters.shadow_rays, uint(asked && push.resume == 0u));
    add_counts();
}
