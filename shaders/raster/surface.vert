// Vertex stage of all three shadings: places the vertex and hands on only what its fragments read.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/layouts.h"
#include "fetch.glsl"

layout(constant_id = CONSTANT_EFFECTS) const uint kEffects = 0u;
layout(constant_id = CONSTANT_SHADING) const uint kShading = SHADING_PHONG;
layout(constant_id = CONSTANT_OUTPUT) const uint kOutput = OUTPUT_RADIANCE;

layout(push_constant, scalar) uniform Push { ShadePush push; };

FETCH_TABLE(polygon_colors, FETCH_COLORS, 10)
FETCH_TABLE(polygon_objects, FETCH_OBJECTS, 12)

layout(location = 0) in vec3 position;
layout(location = 1) in uint polygon;
layout(location = 2) in vec3 normal;
layout(location = 3) in uint material;
layout(location = 4) in vec3 front_color;
layout(location = 5) in vec3 back_color;
layout(location = 6) in vec3 front_rest;
layout(location = 7) in vec3 back_rest;
layout(location = 8) in vec2 uv;
layout(location = 9) in vec3 u_gradient;
layout(location = 10) in vec3 v_gradient;

invariant gl_Position; // fragments are counted by one pipeline and listed by another
layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) flat out uint out_material;
layout(location = 3) out vec3 out_front;
layout(location = 4) out vec3 out_back;
layout(location = 5) flat out vec3 out_flat_front;
layout(location = 6) flat out vec3 out_flat_back;
layout(location = 7) flat out uint out_object;
layout(location = 8) out vec3 out_front_rest;
layout(location = 9) out vec3 out_back_rest;
layout(location = 10) flat out vec3 out_flat_front_rest;
layout(location = 11) flat out vec3 out_flat_back_rest;
layout(location = 12) out vec2 out_uv;
layout(location = 13) out vec3 out_u_gradient;
layout(location = 14) out vec3 out_v_gradient;

#define wants(effect) ((kEffects & (effect)) != 0u)

// A side has one color, or where a texture modulates it two: what is proportional to kd, and the rest.
void hand_on_flat() {
    uint colors = wants(EFFECT_ANY_TEXTURE) ? 2u : 1u;
    uint at = (wants(EFFECT_TWO_SIDED) ? 2u : 1u) * colors * polygon;
    out_flat_front = uintBitsToFloat(fetch_polygon_colors(at).xyz);
    if (wants(EFFECT_ANY_TEXTURE)) out_flat_front_rest = uintBitsToFloat(fetch_polygon_colors(at + 1u).xyz);
    if (!wants(EFFECT_TWO_SIDED)) return;
    out_flat_back = uintBitsToFloat(fetch_polygon_colors(at + colors).xyz);
    if (wants(EFFECT_ANY_TEXTURE)) out_flat_back_rest = uintBitsToFloat(fetch_polygon_colors(at + colors + 1u).xyz);
}

void hand_on_gouraud() {
    out_front = front_color;
    if (wants(EFFECT_TWO_SIDED)) out_back = back_color;
    if (!wants(EFFECT_ANY_TEXTURE)) return;
    out_front_rest = front_rest;
    if (wants(EFFECT_TWO_SIDED)) out_back_rest = back_rest;
}

void hand_on_detail() {
    const uint in_space = EFFECT_MAP_SPHERICAL | EFFECT_MAP_CYLINDRICAL | EFFECT_MAP_PLANAR;
    if (kShading == SHADING_PHONG || wants(in_space)) out_position = position;
    if (kShading == SHADING_PHONG || wants(EFFECT_ANY_TEXTURE | EFFECT_TRANSPARENCY))
        if (wants(EFFECT_MANY_MATERIALS)) out_material = material;
    if (!wants(EFFECT_MAP_UV)) return;
    out_uv = uv;
    if (kShading == SHADING_PHONG && wants(EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP)) out_u_gradient = u_gradient, out_v_gradient = v_gradient;
}

void main() {
    gl_Position = push.clip_from_frame * vec4(position, 1.0);
    if (kOutput == OUTPUT_DEPTH) return;
    if (kOutput == OUTPUT_OBJECT) {
        out_object = fetch_polygon_objects(polygon >> 2u)[polygon & 3u];
        return;
    }
    hand_on_detail();
    if (kShading == SHADING_FLAT) hand_on_flat();
    else if (kShading == SHADING_GOURAUD) hand_on_gouraud();
    else out_normal = normal;
}
