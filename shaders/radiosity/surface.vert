// Vertex stage of radiosity: elements with the radiance of their corners. In: positions of the frame, radiance. Out: both, interpolated.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/layouts.h"

layout(push_constant, scalar) uniform Push { ShadePush push; };
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 radiance;
layout(location = 0) out vec3 out_radiance;

void main() {
    gl_Position = push.clip_from_frame * vec4(position, 1.0);
    out_radiance = radiance;
}
