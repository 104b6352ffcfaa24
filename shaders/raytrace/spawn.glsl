// The rays that a hit sends on: mirrored (S14), refracted (S16, S18), straight through (S13); and the three stops of S19. Includes whatever
// bends them: Fresnel's split, roughness (S17), nested media. In: the hit and its material. Out: rays and nodes of the next generation.
#ifndef LIGHTBENCH_RAYTRACE_SPAWN_GLSL
#define LIGHTBENCH_RAYTRACE_SPAWN_GLSL

#include "raytrace/hit_surface.glsl"
#include "lib/random.glsl"
#include "lib/refraction.glsl"
#include "lib/scatter.glsl"

FETCH_TABLE(media, FETCH_RAYS, 38)
layout(set = 0, binding = 32, scalar) writeonly buffer NextRays { uvec4 next_rays[]; };
layout(set = 0, binding = 34, scalar) writeonly buffer Tree { uvec4 node_words[]; };
layout(set = 0, binding = 40, scalar) writeonly buffer NextMedia { uvec4 next_media[]; };

// What a hit sends on. A weight of 0: nothing.
struct Sent {
    vec3 mirrored, refracted, straight; // weights
    vec3 normal;                        // that directions are taken from: rough where the material is
    vec3 eta;                           // index behind the surface over that before it
    uvec4 media;                        // behind the surface
    uint channels;                      // that are refracted apart: one ray each; 0: one for all
};

const uint kAllChannels = 7u;
uint level_of(Ray r) { return r.level & 0xffu; }
uint channels_of(Ray r) { return r.level >> 8u; } // that the ray carries: a bit each

bool is_any(vec3 w) { return w.x > 0.0 || w.y > 0.0 || w.z > 0.0; }
float largest(vec3 w) { return max(w.x, max(w.y, w.z)); }

// Index of refraction of a medium: a surface + 1, or 0 for the air.
vec3 index_of_medium(uint medium) {
    if (medium == 0u) return vec3(1.0);
    uint at = wants(EFFECT_MANY_MATERIALS) ? kMaterialTexels * (medium - 1u) : 0u;
    return uintBitsToFloat(fetch_materials(at + kMaterialRefraction).xyz);
}

// What is entered lies innermost; what is left may be anywhere. The outermost of more than four is forgotten.
uvec4 with_medium(uvec4 inside, uint medium) { return uvec4(medium, inside.xyz); }
uvec4 without_medium(uvec4 inside, uint medium) {
    if (inside.x == medium) return uvec4(inside.yzw, 0u);
    if (inside.y == medium) return uvec4(inside.x, inside.zw, 0u);
    if (inside.z == medium) return uvec4(inside.xy, inside.w, 0u);
    return uvec4(inside.xyz, inside.w == medium ? 0u : inside.w);
}

// S16. What lies before and behind the surface. A medium that is left although it was never entered began around the eye. Of two media the one
// that was entered last counts, so those that touch should overlap: which of two faces at one place comes first, rounding says, and the ray
// that it refracts starts behind both.
void set_media(uint i, bool entering, uint surface, inout Sent s) {
    uvec4 inside = fetch_media(i);
    uint medium = surface + 1u;
    bool known = any(equal(inside, uvec4(medium)));
    uvec4 before = entering || known ? inside : with_medium(inside, medium);
    s.media = entering ? with_medium(inside, medium) : without_medium(before, medium);
    s.eta = index_of_medium(s.media.x) / index_of_medium(before.x);
}

// Total reflection sends all to the mirror direction; Fresnel's split shares kr + kt out.
void split(Material m, float cosine, vec3 eta, bool refracts, inout vec3 kr, inout vec3 kt) {
    vec3 reflectance = fresnel(cosine, eta);
    vec3 all = kr + kt;
    bvec3 total = equal(reflectance, vec3(1.0));
    bool by_fresnel = wants_ray(RAY_FRESNEL) && (m.splits & kSplitFresnel) != 0u;
    vec3 mirrored = by_fresnel ? all * reflectance : mix(kr, all, total);
    kt = mix(by_fresnel ? all - mirrored : kt, vec3(0.0), total);
    kr = mirrored;
}

Sent sent_on(uint i, Ray r, HitSurface h, Material m, RayPoint p) {
    Sent s = Sent(vec3(0.0), vec3(0.0), vec3(0.0), p.normal, vec3(1.0), uvec4(0u), 0u);
    bool deeper = level_of(r) < push.max_level;
    if (wants_ray(RAY_SCATTER) && m.scatter > 0.0) s.normal = scattered_normal(p.normal, m.scatter, random_unit4(uvec4(r.key, 0u, 0u, push.seed)).xy);
    float cosine = clamp(-dot(r.direction, s.normal), 0.0, 1.0);
    vec3 kr = m.reflection, kt = vec3(0.0);
    if (wants(EFFECT_COOK_TORRANCE)) {
        vec3 tint = fresnel(cosine, m.ior); // a metal mirrors in its own color
        if ((m.kinds & 15u) != kModelPhong) kr *= tint;
    }
    if (wants_ray(RAY_REFRACTED)) {
        kt = m.transmission;
        set_media(i, dot(r.direction, h.face) < 0.0, h.surface, s);
        bool transmits = is_any(kt), fresnel_alone = (m.splits & kSplitFresnel) != 0u && !transmits;
        vec3 eta = fresnel_alone ? m.refraction : s.eta, kr_split = kr, kt_split = kt;
        split(m, cosine, eta, transmits, kr_split, kt_split);
        if (transmits || fresnel_alone) kr = kr_split;
        if (transmits) kt = kt_split;
        if (wants_ray(RAY_DISPERSION) && ((m.splits & kSplitDispersion) != 0u || channels_of(r) != kAllChannels)) s.channels = channels_of(r);
    } else if (wants_ray(RAY_FRESNEL)) {
        vec3 reflectance = fresnel(cosine, m.refraction);
        if ((m.splits & kSplitFresnel) != 0u) kr *= reflectance;
    }
    if (wants_ray(RAY_REFLECTED) && deeper) s.mirrored = p.opacity * kr;
    if (wants_ray(RAY_REFRACTED) && deeper) s.refracted = p.opacity * kt;
    if (wants_ray(RAY_STRAIGHT)) s.straight = vec3(1.0) - p.opacity;
    if (wants_ray(RAY_CUTOFF)) { // S19: adaptive depth
        if (r.weight * largest(s.mirrored) < push.cutoff) s.mirrored = vec3(0.0);
        if (r.weight * largest(s.refracted) < push.cutoff) s.refracted = vec3(0.0);
        if (r.weight * largest(s.straight) < push.cutoff) s.straight = vec3(0.0);
    }
    return s;
}

uint refracted_rays(Sent s) { return is_any(s.refracted) ? max(bitCount(s.channels), 1u) : 0u; }
uint rays_sent(Sent s) { return uint(is_any(s.mirrored)) + refracted_rays(s) + uint(is_any(s.straight)); }

void write_child(uint slot, Ray child, vec3 weight, uint kind, uvec4 media) {
    uvec4 a, b, c;
    pack_ray(child, a, b, c);
    next_rays[kRayTexels * slot] = a, next_rays[kRayTexels * slot + 1u] = b, next_rays[kRayTexels * slot + 2u] = c;
    node_words[kRayNodeTexels * (push.next_first + slot) + 1u] = uvec4(floatBitsToUint(weight), kind);
    if (wants_ray(RAY_REFRACTED)) next_media[slot] = media;
}

// Where a bumped or interpolated normal would send a ray to the wrong side of the face, the face's own normal does.
vec3 mirror_way(Ray r, RayPoint p, vec3 n) {
    vec3 way = mirror_direction(r.direction, n);
    vec3 plain = mirror_direction(r.direction, p.face);
    return dot(way, p.face) > 0.0 ? way : plain;
}

vec3 refracted_way(Ray r, RayPoint p, vec3 n, float eta) {
    vec3 way, plain;
    bool bent = refracted_direction(r.direction, n, eta, way) && dot(way, p.face) < 0.0;
    bool bent_plain = refracted_direction(r.direction, p.face, eta, plain);
    return bent ? way : bent_plain ? plain : r.direction;
}

uint child_key(Ray r, uint kind) { return hash4(uvec4(r.key, kind, 0u, 0u)).x; }

void write_mirrored(uint slot, uint i, Ray r, HitSurface h, RayPoint p, Sent s, float width) {
    vec3 way = mirror_way(r, p, s.normal);
    vec3 origin = offset_origin(h.position, h.error, p.face, way);
    uint level = level_of(r) + 1u | channels_of(r) << 8u;
    uvec4 inside = uvec4(0u);
    if (wants_ray(RAY_REFRACTED)) inside = fetch_media(i);
    write_child(slot, Ray(origin, 0.0, way, kNothing, width, level, r.weight * largest(s.mirrored), child_key(r, 0u)), s.mirrored,
                kRayReflected, inside);
}

void write_refracted(uint slot, Ray r, HitSurface h, RayPoint p, Sent s, float width, uint channels) {
    vec3 mask = channels == 0u ? vec3(1.0) : vec3(channels & 1u, channels >> 1u & 1u, channels >> 2u & 1u);
    // One ray for all channels: they have one index.
    float eta = channels == 0u ? s.eta.y : dot(mask, s.eta);
    vec3 way = refracted_way(r, p, s.normal, eta), weight = s.refracted * mask;
    vec3 origin = offset_origin(h.position, h.error, p.face, way);
    uint level = level_of(r) + 1u | (channels == 0u ? channels_of(r) : channels) << 8u;
    write_child(slot, Ray(origin, 0.0, way, kNothing, width, level, r.weight * largest(weight), child_key(r, 1u + channels)), weight,
                kRayRefracted, s.media);
}

// The same ray goes on behind the surface, from where it began: nothing is lost however near the next surface is.
void write_straight(uint slot, uint i, Ray r, RayHit hit, HitSurface h, Sent s) {
    uvec4 inside = uvec4(0u);
    if (wants_ray(RAY_REFRACTED)) inside = fetch_media(i);
    r.after = hit.t, r.after_number = h.number, r.weight *= largest(s.straight);
    write_child(slot, r, s.straight, kRayStraight, inside);
}

// Room for `wanted` rays: one atomic for the rays of a SIMD group. Where there is no room left nothing is written, and the host finds out.
uint allocate(uint wanted, out bool room) {
    uint before = subgroupExclusiveAdd(wanted), all = subgroupAdd(wanted), first = 0u;
    if (subgroupElect() && all > 0u) first = atomicAdd(counters.children, all);
    uint at = subgroupBroadcastFirst(first) + before;
    room = at + wanted <= push.next_capacity;
    return at;
}

#endif
