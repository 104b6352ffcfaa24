// The surface at every hit of a generation, and the rays that it sends on (S13, S14, S16 to S19). In: rays, hits. Out: the points whose
// lights are to be summed; the next generation of rays and their nodes.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#define LIGHTBENCH_TRACED
#include "raytrace/hit_surface.glsl"
#include "texture.glsl"
#include "raytrace/spawn.glsl"

FETCH_TABLE(hits, FETCH_RAYS, 24)
layout(set = 0, binding = 33, scalar) writeonly buffer Points { uvec4 points[]; };

layout(set = 0, binding = 46, scalar) uniform Camera { EyePush camera; };

vec3 visibility(uint light) { return vec3(1.0); } // no light is summed here

// What the cone of the ray covers of the surface, as steps of picture coordinates: across the plane of incidence, and along it.
Footprint hit_footprint(Material m, HitSurface h, Ray r, float width) {
    Footprint f = Footprint(vec2(0.0), vec2(0.0), vec2(0.0));
    if (!wants(EFFECT_ANY_MAPPING)) return f;
    vec3 du, dv;
    picture_gradients(m, h.position, h.detail, du, dv);
    f.at = picture_uv(m, h.position, h.detail.uv);
    float cosine = abs(dot(h.face, r.direction));
    vec3 along = r.direction - h.face * dot(h.face, r.direction);
    vec3 a = fast_normalize(dot(along, along) < 9.094947e-13 ? abs(h.face.x) < 0.7 ? cross(h.face, vec3(1.0, 0.0, 0.0)) : cross(h.face, vec3(0.0, 1.0, 0.0)) : along);
    vec3 b = cross(h.face, a);
    float stretch = width / max(cosine, 1.5258789e-5); // 2^-16: longer steps are the whole picture in any case
    f.dx = vec2(dot(du, a), dot(dv, a)) * stretch * m.repeats, f.dy = vec2(dot(du, b), dot(dv, b)) * width * m.repeats;
    f.at *= m.repeats;
    return f;
}

// The shading normal on the side that is seen, tilted by bumps.
vec3 shading_normal(Material m, HitSurface h, Footprint f, vec3 face, vec3 to_viewer) {
    bool back = dot(face, h.face) < 0.0;
    vec3 n = back ? -h.normal : h.normal;
    if (!wants(EFFECT_ANY_BUMP)) return n;
    float lod = 0.0;
    if (wants(EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP)) lod = lod_of(m.bump, f.dx, f.dy);
    vec3 bumped = bumped_normal(m, h.normal, h.position, h.detail, lod);
    vec3 facing = keep_facing(back ? -bumped : bumped, n, to_viewer);
    return is_bumped(m) ? facing : n;
}

RayPoint point_of(Material m, HitSurface h, Ray r, float width) {
    vec3 to_viewer = -r.direction;
    RayPoint p;
    p.face = dot(h.face, to_viewer) < 0.0 ? -h.face : h.face;
    Footprint f = hit_footprint(m, h, r, width);
    vec4 texture = vec4(1.0);
    if (wants(EFFECT_ANY_TEXTURE)) texture = texture_color(m, f);
    p.position = h.position, p.surface = h.surface;
    p.normal = shading_normal(m, h, f, p.face, to_viewer);
    p.origin = offset_origin(h.position, h.error, p.face, p.face);
    p.diffuse = m.diffuse * texture.rgb;
    p.opacity = vec3(1.0);
    bool hidden = (m.splits & kOneSided) != 0u && dot(h.face, to_viewer) < 0.0;
    if (wants(EFFECT_TRANSPARENCY)) p.opacity = hidden ? vec3(0.0) : m.opacity * texture.a;
    p.children = 0u;
    p.pad0 = p.pad1 = p.pad2 = p.pad3 = 0.0;
    return p;
}

// Rays that a surface which does not refract sends on, to lights too, start beyond what refracts and touches it, so that none meets that once
// more or less, as rounding has it: what touches lies no farther across the surface than along the ray that found it. The other way round
// only where the ray passed (S13) what touches: otherwise it would have been hit.
void leave_what_touches(inout HitSurface h, Ray r, float t) {
    if (!wants_ray(RAY_REFRACTED)) return;
    float touching = kTouching * slack_of(max(abs(r.origin), abs(h.position)));
    bool passed = !refracts(r.after_number) && r.after > t - touching; // not from kNothing, which refracts by its bits
    h.error += !refracts(h.number) || passed ? touching : 0.0;
}

void write_children(uint at, uint i, Ray r, RayHit hit, HitSurface h, RayPoint p, Sent s, float width) {
    if (wants_ray(RAY_REFLECTED))
        if (is_any(s.mirrored)) write_mirrored(at++, i, r, h, p, s, width);
    if (wants_ray(RAY_REFRACTED)) {
        uint left = s.channels;
        for (uint n = refracted_rays(s); n > 0u; --n) {
            uint channel = left & (~left + 1u); // the lowest bit
            write_refracted(at++, r, h, p, s, width, channel);
            left ^= channel;
        }
    }
    if (wants_ray(RAY_STRAIGHT))
        if (is_any(s.straight)) write_straight(at++, i, r, hit, h, s);
}

void count_children(Sent s) {
    if (!wants_ray(RAY_COUNT)) return;
    atomicAdd(counters.reflected, uint(is_any(s.mirrored)));
    atomicAdd(counters.refracted, refracted_rays(s));
    atomicAdd(counters.straight, uint(is_any(s.straight)));
}

void write_point(uint i, RayPoint p) {
    uint at = kRayPointTexels * i;
    points[at] = uvec4(floatBitsToUint(p.position), p.surface), points[at + 1u] = uvec4(floatBitsToUint(p.normal), p.children);
    if (wants_ray(RAY_SHADOWS)) points[at + 2u] = uvec4(floatBitsToUint(p.origin), 0u), points[at + 3u] = uvec4(floatBitsToUint(p.face), 0u);
    if (wants(EFFECT_ANY_TEXTURE)) points[at + 4u] = uvec4(floatBitsToUint(p.diffuse), 0u);
    if (wants(EFFECT_TRANSPARENCY)) points[at + 5u] = uvec4(floatBitsToUint(p.opacity), 0u);
}

uint object_of(uint ref) {
    uint type = type_of(ref), index = index_of(ref);
    if (wants_ray(RAY_TRIANGLES) && type == kTypeTriangle) return fetch_triangles(kTriangleTexels * index + 2u).w;
    if (wants_ray(RAY_SPHERES) && type == kTypeSphere) return fetch_spheres(kSphereTexels * index + 1u).z;
    if (wants_ray(RAY_SHAPES)) return fetch_shapes(kShapeTexels * index + 4u).z;
    return 0u;
}

// Of outputs that no light is summed for.
void write_fact(uint node, RayHit hit, RayPoint p) {
    vec3 fact = p.normal;
    if (kOutput == OUTPUT_DEPTH) fact = vec3(dot(p.position - camera.eye, camera.axis));
    if (kOutput == OUTPUT_OBJECT) fact = vec3(float(object_of(hit.ref) + 1u));
    node_words[kRayNodeTexels * node] = uvec4(floatBitsToUint(fact), 0u);
}

void main() {
    uint i = invocation(), k = min(i, push.count - 1u);
    count_done(push.count);
    bool live = i < push.count;
    uint from = ray_of_hit(k);
    Ray r = read_ray(from);
    uvec4 words = fetch_hits(k);
    RayHit hit = RayHit(uintBitsToFloat(words.x), words.y, uintBitsToFloat(words.z), uintBitsToFloat(words.w));
    ray.o = r.origin, ray.d = r.direction;
    float width = r.width + hit.t * push.spread;
    HitSurface h = hit_surface(hit);
    leave_what_touches(h, r, hit.t);
    Material m = read_traced_material(h.surface);
    RayPoint p = point_of(m, h, r, width);
    if (kOutput == OUTPUT_NORMAL || kOutput == OUTPUT_DEPTH || kOutput == OUTPUT_OBJECT) {
        if (live) write_fact(push.first + from, hit, p);
        return;
    }
    if (wants_ray(RAY_REFLECTED | RAY_REFRACTED | RAY_STRAIGHT)) {
        Sent s = sent_on(from, r, h, m, p);
        if (!live) s.mirrored = s.refracted = s.straight = vec3(0.0);
        uint wanted = rays_sent(s);
        bool room;
        uint at = allocate(wanted, room);
        p.children = (push.next_first + at) << 3u | wanted;
        if (room && wanted > 0u) write_children(at, from, r, hit, h, p, s, width);
        count_children(s);
    }
    if (live) write_point(i, p);
}
