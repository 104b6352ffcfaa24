// Fragment stage of all three shadings: takes the polygon's color (flat), interpolates the vertices' (Gouraud), or interpolates the
// normal and evaluates the model here (Phong; Phong 1975, "Illumination for Computer Generated Pictures").
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shade.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) flat in uint material;
layout(location = 3) in vec3 front_color;
layout(location = 4) in vec3 back_color;
layout(location = 5) flat in vec3 flat_front;
layout(location = 6) flat in vec3 flat_back;
layout(location = 7) flat in uint object;

layout(location = 0) out vec4 color;

// Unit, on the side that is seen. Where the interpolated normal vanishes (opposite normals in a file) the face's own stands in;
// 2^-40: shorter than that, the rounding of three unit normals' mean (2^-23 each) is what the vector consists of.
vec3 seen_normal() {
    vec3 n = normal;
    if (wants(EFFECT_VANISHING_NORMALS)) {
        vec3 face = cross(dFdx(position), dFdy(position));
        if (dot(face, push.eye - position) < 0.0) face = -face;
        if (dot(n, n) < 9.094947e-13) n = gl_FrontFacing ? face : -face;
    }
    n *= inversesqrt(max(dot(n, n), kLeastNormal));
    return wants(EFFECT_TWO_SIDED) && !gl_FrontFacing ? -n : n;
}

vec3 shade_fragment() {
    Surface s = Surface(position, seen_normal(), direction_to_viewer(position));
    if (kOutput == OUTPUT_NORMAL) return s.normal;
    return shade(s, read_material(material));
}

void main() {
    color.a = 1.0;
    bool back = wants(EFFECT_TWO_SIDED) && !gl_FrontFacing;
    if (kOutput == OUTPUT_DEPTH) {
        color.rgb = vec3(1.0 / gl_FragCoord.w);
    } else if (kOutput == OUTPUT_OBJECT) {
        color.rgb = vec3(float(object + 1u));
    } else if (kShading == SHADING_FLAT) {
        color.rgb = flat_front;
        if (wants(EFFECT_TWO_SIDED)) color.rgb = back ? flat_back : flat_front;
    } else if (kShading == SHADING_GOURAUD) {
        color.rgb = front_color;
        if (wants(EFFECT_TWO_SIDED)) color.rgb = back ? back_color : front_color;
    } else {
        color.rgb = shade_fragment();
    }
}
