// The fragments of a surface in all three shadings: takes the polygon's color (flat), interpolates the vertices' (Gouraud), or interpolates
// the normal and evaluates the model here (Phong; Phong 1975, "Illumination for Computer Generated Pictures"). Textures are looked up
// here in each of them: they modulate what was shaded before.
#include "detail.glsl"
#include "environment.glsl"
#include "texture.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) flat in uint material;
layout(location = 3) in vec3 front_color;
layout(location = 4) in vec3 back_color;
layout(location = 5) flat in vec3 flat_front;
layout(location = 6) flat in vec3 flat_back;
layout(location = 7) flat in uint object;
layout(location = 8) in vec3 front_rest;
layout(location = 9) in vec3 back_rest;
layout(location = 10) flat in vec3 flat_front_rest;
layout(location = 11) flat in vec3 flat_back_rest;
layout(location = 12) in vec2 uv;
layout(location = 13) in vec3 u_gradient;
layout(location = 14) in vec3 v_gradient;

// Unit, outwards. Where the interpolated normal vanishes (opposite normals in a file) the face's own stands in;
// 2^-40: shorter than that, the rounding of three unit normals' mean (2^-23 each) is what the vector consists of.
real3 outward_normal() {
    real3 n = real3(normal);
    if (wants(EFFECT_VANISHING_NORMALS)) {
        vec3 face = cross(dFdx(position), dFdy(position));
        if (dot(face, push.eye - position) < 0.0) face = -face;
        if (dot(n, n) < 9.094947e-13) n = real3(gl_FrontFacing ? face : -face);
    }
    return n * inversesqrt(max(dot(n, n), kLeastNormal));
}

Detail fragment_detail() {
    Detail d = kNoDetail;
    if (wants(EFFECT_MAP_UV)) {
        d.uv = uv;
        if (wants(EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP)) d.u_gradient = u_gradient, d.v_gradient = v_gradient;
    }
    return d;
}

Footprint footprint(Material m) {
    Footprint f = Footprint(vec2(0.0), vec2(0.0), vec2(0.0));
    if (!wants(EFFECT_ANY_MAPPING)) return f;
    vec3 at = vec3(0.0);
    if (wants(EFFECT_MAP_SPHERICAL | EFFECT_MAP_CYLINDRICAL | EFFECT_MAP_PLANAR)) at = position;
    vec2 own = vec2(0.0);
    if (wants(EFFECT_MAP_UV)) own = uv;
    f.at = picture_uv(m, at, own);
    f.dx = dFdx(f.at), f.dy = dFdy(f.at);
    bool around = (wants(EFFECT_MAP_SPHERICAL) && mapped(m, EFFECT_MAP_SPHERICAL, kMapSpherical)) ||
                  (wants(EFFECT_MAP_CYLINDRICAL) && mapped(m, EFFECT_MAP_CYLINDRICAL, kMapCylindrical));
    if (around) f.dx = wrapped(f.dx), f.dy = wrapped(f.dy);
    f.at *= m.repeats, f.dx *= m.repeats, f.dy *= m.repeats;
    return f;
}

vec3 mirrored(Surface s, Material m) {
    if (!wants(EFFECT_MIRROR_ENVIRONMENT)) return vec3(0.0);
    vec3 r = reflected(vec3(s.normal), vec3(s.to_viewer));
    float turn = max(length(dFdx(r)), length(dFdy(r)));
    return mirror_factor(s, m) * surrounding_radiance(m, r, turn);
}

vec3 shade_fragment(Material m, Footprint f, vec3 modulation) {
    bool back = wants(EFFECT_TWO_SIDED) && !gl_FrontFacing;
    real3 n = outward_normal(), smooth_normal = back ? -n : n;
    Surface s = Surface(position, smooth_normal, direction_to_viewer(position));
    if (wants(EFFECT_ANY_BUMP)) {
        float lod = 0.0;
        if (wants(EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP)) lod = lod_of(m.bump, f.dx, f.dy);
        vec3 bumped = bumped_normal(m, vec3(n), position, fragment_detail(), lod);
        if (is_bumped(m)) s.normal = real3(keep_facing(back ? -bumped : bumped, vec3(smooth_normal), vec3(s.to_viewer)));
    }
    if (kOutput == OUTPUT_NORMAL) return vec3(s.normal);
    m.diffuse *= modulation;
    return vec3(shade(s, m)) + mirrored(s, m);
}

struct Fragment {
    vec3 radiance;
    vec3 opacity; // t
};

// What was shaded before, on the side that is seen. An input that the vertex stage does not write may not even be named: hence no `?`.
vec3 flat_radiance(vec3 modulation) {
    vec3 modulated = flat_front, rest = vec3(0.0);
    if (wants(EFFECT_ANY_TEXTURE)) rest = flat_front_rest;
    if (wants(EFFECT_TWO_SIDED)) {
        if (!gl_FrontFacing) modulated = flat_back;
        if (wants(EFFECT_ANY_TEXTURE)) rest = gl_FrontFacing ? rest : flat_back_rest;
    }
    return modulated * modulation + rest;
}

vec3 gouraud_radiance(vec3 modulation) {
    vec3 modulated = front_color, rest = vec3(0.0);
    if (wants(EFFECT_ANY_TEXTURE)) rest = front_rest;
    if (wants(EFFECT_TWO_SIDED)) {
        if (!gl_FrontFacing) modulated = back_color;
        if (wants(EFFECT_ANY_TEXTURE)) rest = gl_FrontFacing ? rest : back_rest;
    }
    return modulated * modulation + rest;
}

Fragment surface_fragment() {
    Material m = kNoMaterial;
    if (kShading == SHADING_PHONG || wants(EFFECT_ANY_TEXTURE | EFFECT_TRANSPARENCY)) {
        uint index = 0u;
        if (wants(EFFECT_MANY_MATERIALS)) index = material;
        m = read_material(index);
    }
    Footprint f = footprint(m);
    vec4 color = vec4(1.0);
    if (wants(EFFECT_ANY_TEXTURE)) color = texture_color(m, f);
    vec3 radiance;
    if (kShading == SHADING_FLAT) radiance = flat_radiance(color.rgb);
    else if (kShading == SHADING_GOURAUD) radiance = gouraud_radiance(color.rgb);
    else radiance = shade_fragment(m, f, color.rgb);
    return Fragment(radiance, m.opacity * color.a);
}
