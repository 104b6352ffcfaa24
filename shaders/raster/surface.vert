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

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) flat out uint out_material;
layout(location = 3) out vec3 out_front;
layout(location = 4) out vec3 out_back;
layout(location = 5) flat out vec3 out_flat_front;
layout(location = 6) flat out vec3 out_flat_back;
layout(location = 7) flat out uint out_object;

void hand_on_flat() {
    bool both = (kEffects & EFFECT_TWO_SIDED) != 0u;
    uint at = both ? 2u * polygon : polygon;
    out_flat_front = uintBitsToFloat(fetch_polygon_colors(at).xyz);
    if (both) out_flat_back = uintBitsToFloat(fetch_polygon_colors(at + 1u).xyz);
}

void main() {
    gl_Position = push.clip_from_frame * vec4(position, 1.0);
    if (kOutput == OUTPUT_DEPTH) return;
    if (kOutput == OUTPUT_OBJECT) {
        out_object = fetch_polygon_objects(polygon >> 2u)[polygon & 3u];
    } else if (kShading == SHADING_FLAT) {
        hand_on_flat();
    } else if (kShading == SHADING_GOURAUD) {
        out_front = front_color;
        if ((kEffects & EFFECT_TWO_SIDED) != 0u) out_back = back_color;
    } else {
        out_position = position;
        out_normal = normal;
        if ((kEffects & EFFECT_MANY_MATERIALS) != 0u) out_material = material;
    }
}
