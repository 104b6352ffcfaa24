// One face of a hemi-cube drawn: the centre of projection is the patch that was chosen on the device.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "radiosity/hemicube_view.glsl"

layout(push_constant, scalar) uniform Push { HemicubePush push; };
layout(location = 0) in vec3 position;
layout(location = 1) in uvec2 sides; // the element, the one behind it: of the triangles that this vertex provokes
layout(location = 0) flat out uvec2 element_sides;

const float kNear = 5e-5; // of the patch's radius: 2.5e-5 of its size (HC-10 asks for 1e-4 at most)

// Reversed depth with the far plane at infinity. The viewport of a side is the part above the horizon: what is below is clipped exactly.
void main() {
    HemicubeView v = read_view(push.cube);
    vec3 across, along, forward, p = position - v.center;
    face_axes(v, push.face, across, along, forward);
    float w = dot(p, forward), y = dot(p, along);
    element_sides = push.face == 2u || push.face == 3u ? sides.yx : sides; // these two are drawn as in a mirror
    gl_Position = vec4(dot(p, across), push.face == 0u ? y : 2.0 * y - w, kNear * v.radius, w);
    if (v.patch_number == kNoElement) gl_Position = vec4(0.0, 0.0, -1.0, 1.0); // in front of the near plane
}
