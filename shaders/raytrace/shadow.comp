// How much of each light reaches each point (S15): one invocation a point and a light, one layer of work groups a light. In: points,
// lights, primitives. Out: visibility per channel.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define LIGHTBENCH_TRACED
#define LIGHTBENCH_ANY_HIT (!wants_ray(RAY_CLEAR_SHADOWS))
#include "raytrace/walks.glsl"
#include "raytrace/points.glsl"
#include "raytrace/hit_surface.glsl"
#include "texture.glsl"

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

// What of the light passes the surface that was hit, straight on: the clear part (S13), and the transmitted part unbent.
vec3 passing(RayHit hit) {
    HitSurface h = hit_surface(hit);
    Material m = read_traced_material(h.surface);
    vec3 opacity = vec3(1.0), transmitted = vec3(0.0);
    if (wants(EFFECT_TRANSPARENCY)) opacity = m.opacity;
    if (wants(EFFECT_TEXTURE_ALPHA)) {
        Footprint none = Footprint(picture_uv(m, h.position, h.detail.uv) * m.repeats, vec2(0.0), vec2(0.0));
        opacity *= texture_color(m, none).a;
    }
    if (wants_ray(RAY_REFRACTED)) transmitted = m.transmission;
    return vec3(1.0) - opacity + opacity * transmitted;
}

// From surface to surface in the order of their distances, so that the product is the same whatever finds them. In: what is left of the
// light, and behind what. True if it has arrived, or nothing is left.
bool pass_through(inout RayHit hit, inout Walk w, inout vec3 clear, float limit) {
    const uint crossings = wants_ray(RAY_RESUME) ? 1u : 8u;
    bool arrived = w.node == kNothing && hit.ref == kNothing;
    for (uint n = 0u; n < crossings && !arrived; ++n) {
        if (!walk(hit, false, w)) return false;
        arrived = hit.ref == kNothing;
        if (!arrived) {
            hit = at_distance(hit);
            clear *= passing(hit);
            set_after(hit.t, hit_number);
            arrived = clear.x <= 0.0 && clear.y <= 0.0 && clear.z <= 0.0;
            hit = RayHit(limit, kNothing, 0.0, 0.0), hit_number = 0u;
            w = Walk(arrived ? kNothing : 0u, 1u, 0u, 0u);
        }
    }
    return arrived;
}

void main() {
    uint i = invocation(), layer = gl_WorkGroupID.z, k = min(i, push.count - 1u);
    if (layer == 0u) count_done(push.count);
    bool live = i < push.count;
    if (!wants_ray(RAY_PACKETS) && !live) return;
    Ray r;
    float limit;
    bool asked = shadow_ray(k, read_light(push.first_light + push.layer + layer), r, limit);
    asked = asked && live;
    start_ray(r);
    RayHit hit = RayHit(asked ? limit : -1.0, kNothing, 0.0, 0.0);
    Walk w = walk_start(asked);
    vec3 clear = vec3(1.0);
    if (wants_ray(RAY_RESUME) && push.resume != 0u) {
        take_up_walk(k, w, hit); // one light a dispatch
        if (wants_ray(RAY_CLEAR_SHADOWS)) take_up_light(k, clear);
    }
    bool done;
    if (wants_ray(RAY_CLEAR_SHADOWS)) done = pass_through(hit, w, clear, limit);
    else done = walk(hit, true, w), clear = vec3(hit.ref == kNothing ? 1.0 : 0.0);
    if (live) {
        // A light behind the face is hidden by the surface itself, whatever the shading normal says (LI-3).
        visible[(push.layer + layer) * push.count + i] = asked ? vec4(clear, 0.0) : vec4(0.0);
        if (wants_ray(RAY_RESUME)) {
            put_down_walk(i, w, hit);
            if (wants_ray(RAY_CLEAR_SHADOWS)) put_down_light(i, clear);
        }
        count_unfinished(done);
    }
    if (wants_ray(RAY_COUNT)) atomicAdd(counters.shadow_rays, uint(asked && push.resume == 0u));
    add_counts();
}
