// Shades points once each: polygon centres (flat) or vertices (Gouraud). In: their positions, normals, materials, detail. Out: for each
// side that is seen (its front, or its front and its back) one color; where textures are drawn two, what a texture modulates and the rest.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "detail.glsl"
#include "environment.glsl"

layout(local_size_x = 64) in;

FETCH_TABLE(positions, FETCH_POINTS, 4)
FETCH_TABLE(normals, FETCH_POINTS, 6)
FETCH_TABLE(detail, FETCH_DETAIL, 16)
layout(set = 0, binding = 8, scalar) writeonly buffer Colors { vec4 colors[]; };

Detail read_detail(uint i) {
    Detail d = kNoDetail;
    if (!wants(EFFECT_MAP_UV) || !wants(EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP)) return d;
    d.uv = uintBitsToFloat(fetch_detail(3u * i).xy);
    d.u_gradient = uintBitsToFloat(fetch_detail(3u * i + 1u).xyz);
    d.v_gradient = uintBitsToFloat(fetch_detail(3u * i + 2u).xyz);
    return d;
}

vec3 mirrored(Surface s, Material m) {
    if (!wants(EFFECT_MIRROR_ENVIRONMENT)) return vec3(0.0);
    return mirror_factor(s, m) * surrounding_radiance(m, reflected(s.normal, s.to_viewer), 0.0);
}

void write_side(uint at, Surface s, Material m, vec3 smooth_normal) {
    if (is_bumped(m)) s.normal = keep_facing(s.normal, smooth_normal, s.to_viewer);
    if (kOutput == OUTPUT_NORMAL) {
        colors[at] = vec4(s.normal, 1.0);
    } else if (wants(EFFECT_ANY_TEXTURE)) {
        colors[at] = vec4(shade_part(s, m, kPartDiffuse), 1.0);
        colors[at + 1u] = vec4(shade_part(s, m, kPartRest) + mirrored(s, m), 1.0);
    } else {
        colors[at] = vec4(shade(s, m) + mirrored(s, m), 1.0);
    }
}

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (i >= push.point_count) return;
    uvec4 normal = fetch_normals(i);
    Material m = read_material(normal.w);
    Surface s;
    s.position = uintBitsToFloat(fetch_positions(i).xyz);
    s.to_viewer = direction_to_viewer(s.position);
    vec3 smooth_normal = uintBitsToFloat(normal.xyz);
    s.normal = bumped_normal(m, smooth_normal, s.position, read_detail(i), 0.0);
    const uint colors_of_side = wants(EFFECT_ANY_TEXTURE) ? 2u : 1u;
    uint at = (wants(EFFECT_TWO_SIDED) ? 2u : 1u) * colors_of_side * i;
    write_side(at, s, m, smooth_normal);
    if (!wants(EFFECT_TWO_SIDED)) return;
    s.normal = -s.normal;
    write_side(at + colors_of_side, s, m, -smooth_normal);
}
