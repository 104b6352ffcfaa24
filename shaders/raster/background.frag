// Fragment stage of the background: the environment, seen where nothing stands before it. In place of clip_from_frame the pass pushes the
// matrix that takes (x, y, 0, 1), pixels, to a direction of the world.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "environment.glsl"

layout(location = 0) out vec4 color;

void main() {
    vec3 d = (push.clip_from_frame * vec4(gl_FragCoord.xy, 0.0, 1.0)).xyz;
    d *= inversesqrt(dot(d, d));
    color = vec4(environment_radiance(d, max(length(dFdx(d)), length(dFdy(d)))), 1.0);
}
