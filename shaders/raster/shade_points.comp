// Shades points once each: polygon centres (flat) or vertices (Gouraud). In: their positions, normals, materials. Out: one color a
// point, or two (its front, its back) where surfaces are seen from both sides.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shade.glsl"

layout(local_size_x = 64) in;

FETCH_TABLE(positions, FETCH_POINTS, 4)
FETCH_TABLE(normals, FETCH_POINTS, 6)
layout(set = 0, binding = 8, scalar) writeonly buffer Colors { vec4 colors[]; };

vec3 evaluate(Surface s, Material m) {
    if (kOutput == OUTPUT_NORMAL) return s.normal;
    return shade(s, m);
}

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (i >= push.point_count) return;
    uvec4 normal = fetch_normals(i);
    Surface s;
    s.position = uintBitsToFloat(fetch_positions(i).xyz);
    s.normal = uintBitsToFloat(normal.xyz);
    s.to_viewer = direction_to_viewer(s.position);
    Material m = read_material(normal.w);
    if (wants(EFFECT_TWO_SIDED)) {
        colors[2u * i] = vec4(evaluate(s, m), 1.0);
        s.normal = -s.normal;
        colors[2u * i + 1u] = vec4(evaluate(s, m), 1.0);
    } else {
        colors[i] = vec4(evaluate(s, m), 1.0);
    }
}
