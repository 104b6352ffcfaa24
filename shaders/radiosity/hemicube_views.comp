// From the patches that were chosen to where their hemi-cubes stand. In: numbers of patches, shooters. Out: a table of views.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "fetch.glsl"
#include "shared/radiosity.h"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { HemicubePush push; };
FETCH_TABLE(shooters, FETCH_SHOOTERS, 46)
layout(set = 0, binding = 48, scalar) readonly buffer Chosen { uint chosen[]; };
layout(set = 0, binding = 49, scalar) writeonly buffer Views { uvec4 view_words[]; };

// Without a patch: the axes of the world, so that nothing has to deal with directions that are none.
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= push.count) return;
    uint number = chosen[i], from = kShooterTexels * (number == kNoElement ? 0u : number), to = kHemicubeViewTexels * i;
    uvec4 a = fetch_shooters(from), b = fetch_shooters(from + 1u), c = fetch_shooters(from + 2u), d = fetch_shooters(from + 3u);
    vec3 normal = uintBitsToFloat(b.xyz), tangent = uintBitsToFloat(c.xyz);
    view_words[to] = uvec4(a.xyz, number);
    view_words[to + 1u] = uvec4(c.xyz, c.w);
    view_words[to + 2u] = uvec4(floatBitsToUint(cross(normal, tangent)), d.w);
    view_words[to + 3u] = b;
    view_words[to + 4u] = uvec4(a.w, 0u, 0u, 0u);
}
