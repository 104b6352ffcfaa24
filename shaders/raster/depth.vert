// Vertex stage of passes that need nothing but depth: the driver's floor in benchmarks.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/layouts.h"

layout(push_constant, scalar) uniform Push { ShadePush push; };
layout(location = 0) in vec3 position;

void main() { gl_Position = push.clip_from_frame * vec4(position, 1.0); }
