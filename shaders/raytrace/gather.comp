// From the leaves of the ray trees to their roots, a generation at a time: I = color + sum over the children of weight * I(child) (S14).
// The order of a sum is that in which the children were sent, so the same bits come out whatever order rays were traced in.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/effects.h"
#include "shared/rays.h"
#include "fetch.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { GatherPush push; };
FETCH_TABLE(tree, FETCH_RAYS, 28)
layout(set = 0, binding = 34, scalar) buffer Tree { uvec4 node_words[]; };

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (i >= push.count) return;
    uint at = kRayNodeTexels * (push.first + i);
    uvec4 node = fetch_tree(at);
    vec3 color = (push.parts & 1u << kRayEye) != 0u ? uintBitsToFloat(node.xyz) : vec3(0.0);
    uint child = node.w >> 3u;
    for (uint n = node.w & 7u; n > 0u; --n, ++child) {
        vec3 arriving = uintBitsToFloat(fetch_tree(kRayNodeTexels * child).xyz);
        uvec4 weighed = fetch_tree(kRayNodeTexels * child + 1u);
        vec3 weight = (push.parts & 1u << weighed.w) != 0u ? uintBitsToFloat(weighed.xyz) : vec3(0.0);
        // A weight of 0 stands for nothing, whatever arrives: 0 times an infinity is no number (TR-1).
        color += mix(weight * arriving, vec3(0.0), equal(weight, vec3(0.0)));
    }
    if ((node.w & 7u) > 0u || push.parts != kAllParts) node_words[at] = uvec4(floatBitsToUint(color), node.w);
}
