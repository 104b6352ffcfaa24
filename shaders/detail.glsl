// Surface detail: where pictures lie on a surface (S10), and the normals that bumps tilt (S11). In: a material, a point of the frame, the
// detail of a mesh. Out: picture coordinates, a unit normal. Knows no derivatives, so that every stage can use it.
#ifndef LIGHTBENCH_DETAIL_GLSL
#define LIGHTBENCH_DETAIL_GLSL

#include "shade.glsl"
#include "lib/texels.glsl"
#include "lib/bump.glsl"
#include "lib/checker.glsl"
#include "lib/mapping.glsl"
#include "lib/noise.glsl"

// Of a mesh with uv of its own; 0 elsewhere.
struct Detail {
    vec2 uv;
    vec3 u_gradient, v_gradient; // per frame unit
};
const Detail kNoDetail = Detail(vec2(0.0), vec3(0.0), vec3(0.0));

bool mapped(Material m, uint effect, uint kind) { return of_kind(effect, EFFECT_ANY_MAPPING, (m.kinds >> 8u) & 15u, kind); }

vec3 mapping_point(Material m, vec3 p) {
    vec4 q = vec4(p, 1.0);
    return vec3(dot(m.map_x, q), dot(m.map_y, q), dot(m.map_z, q));
}

// A gradient in mapping space, as one in the frame: the transpose of the map.
vec3 to_frame(Material m, vec3 g) { return m.map_x.xyz * g.x + m.map_y.xyz * g.y + m.map_z.xyz * g.z; }

// Picture coordinates, once around or across the object.
vec2 picture_uv(Material m, vec3 p, vec2 uv) {
    vec2 at = vec2(0.0);
    vec3 q = vec3(0.0);
    if (wants(EFFECT_MAP_SPHERICAL | EFFECT_MAP_CYLINDRICAL | EFFECT_MAP_PLANAR)) q = mapping_point(m, p);
    if (wants(EFFECT_MAP_UV) && mapped(m, EFFECT_MAP_UV, kMapUv)) at = uv;
    if (wants(EFFECT_MAP_SPHERICAL) && mapped(m, EFFECT_MAP_SPHERICAL, kMapSpherical)) at = map_spherical(q);
    if (wants(EFFECT_MAP_CYLINDRICAL) && mapped(m, EFFECT_MAP_CYLINDRICAL, kMapCylindrical)) at = map_cylindrical(q);
    if (wants(EFFECT_MAP_PLANAR) && mapped(m, EFFECT_MAP_PLANAR, kMapPlanar)) at = map_planar(q);
    return at;
}

// How the picture coordinates change along the surface, per frame unit.
void picture_gradients(Material m, vec3 p, Detail d, out vec3 du, out vec3 dv) {
    du = d.u_gradient, dv = d.v_gradient;
    vec3 q = vec3(0.0), a = vec3(0.0), b = vec3(0.0);
    if (wants(EFFECT_MAP_SPHERICAL | EFFECT_MAP_CYLINDRICAL | EFFECT_MAP_PLANAR)) q = mapping_point(m, p);
    if (wants(EFFECT_MAP_SPHERICAL)) {
        map_spherical_gradients(q, a, b);
        if (mapped(m, EFFECT_MAP_SPHERICAL, kMapSpherical)) du = to_frame(m, a), dv = to_frame(m, b);
    }
    if (wants(EFFECT_MAP_CYLINDRICAL)) {
        map_cylindrical_gradients(q, a, b);
        if (mapped(m, EFFECT_MAP_CYLINDRICAL, kMapCylindrical)) du = to_frame(m, a), dv = to_frame(m, b);
    }
    if (wants(EFFECT_MAP_PLANAR)) {
        map_planar_gradients(q, a, b);
        if (mapped(m, EFFECT_MAP_PLANAR, kMapPlanar)) du = to_frame(m, a), dv = to_frame(m, b);
    }
}

// Of the height that a bump adds, per frame unit: its gradient in space or along the surface.
vec3 bump_gradient(Material m, vec3 n, vec3 p, Detail d, float lod) {
    uint kind = (m.kinds >> 12u) & 15u; // asked for even where one kind is all there is: a surface may have none
    vec3 gradient = vec3(0.0);
    if (wants(EFFECT_BUMP_WAVES | EFFECT_BUMP_NOISE)) {
        vec3 q = m.bump_scale * mapping_point(m, p), g = vec3(0.0);
        if (wants(EFFECT_BUMP_WAVES)) {
            vec3 w = waves(q).xyz;
            if (kind == kBumpWaves) g = w;
        }
        if (wants(EFFECT_BUMP_NOISE)) {
            vec3 w = gradient_noise(q).xyz;
            if (kind == kBumpNoise) g = w;
        }
        gradient = m.amplitude * to_frame(m, m.bump_scale * g);
    }
    if (wants(EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP)) {
        vec3 du, dv;
        picture_gradients(m, p, d, du, dv);
        vec2 at = picture_uv(m, p, d.uv) * m.repeats;
        if (wants(EFFECT_BUMP_HEIGHT)) {
            vec2 g = height_gradient(m.bump, at, lod) * m.repeats;
            if (kind == kBumpHeight) gradient = m.amplitude * (g.x * du + g.y * dv);
        }
        if (wants(EFFECT_NORMAL_MAP)) {
            vec3 t, b;
            tangent_frame(n, du, dot(cross(n, du), dv) < 0.0 ? -1.0 : 1.0, t, b);
            vec3 g = normal_map_gradient(sample_trilinear(m.bump, at, lod).xyz, m.amplitude, t, b);
            if (kind == kBumpNormalMap) gradient = g;
        }
    }
    return gradient;
}

bool is_bumped(Material m) { return wants(EFFECT_ANY_BUMP) && ((m.kinds >> 12u) & 15u) != kBumpNone; }

// n is the outward normal, whichever side is seen.
vec3 bumped_normal(Material m, vec3 n, vec3 p, Detail d, float lod) {
    if (!wants(EFFECT_ANY_BUMP)) return n;
    return perturb_normal(n, bump_gradient(m, n, p, d, lod));
}

#endif
