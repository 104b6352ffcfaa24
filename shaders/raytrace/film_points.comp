// The roots of a batch's ray trees as points of the lattice. In: nodes, the list of points. Out: linear radiance.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/effects.h"
#include "shared/rays.h"
#include "fetch.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { FilmPush push; };
FETCH_TABLE(eye_points, FETCH_EYE_POINTS, 24)
FETCH_TABLE(tree, FETCH_RAYS, 28)
layout(set = 0, binding = 0, scalar) writeonly buffer Lattice { vec4 radiance[]; };

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (i >= push.count) return;
    radiance[fetch_eye_points(push.tile_x + i).w] = vec4(uintBitsToFloat(fetch_tree(kRayNodeTexels * i).xyz), 1.0);
}
