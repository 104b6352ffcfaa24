// Sums of each patch over its elements: unshot energy, by which the next ones are chosen, and what was absorbed (RS-4).
// In: states. Out: tallies. Some lanes a patch, so that none has more elements than the loops of lavapipe allow.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "fetch.glsl"
#include "lib/sum.glsl"
#include "shared/solve.h"

layout(local_size_x = 128) in;
layout(push_constant, scalar) uniform Push { TallyPush push; };
FETCH_TABLE(elements, FETCH_SOLVE_TABLES, 0)
FETCH_TABLE(state, FETCH_SOLVE_TABLES, 2)
FETCH_TABLE(patches, FETCH_SOLVE_TABLES, 4)
layout(set = 0, binding = 6, scalar) writeonly buffer Tally { SolveTally tally[]; };

shared vec3 unshot_of[kTallyLanes];
shared vec3 absorbed_of[kTallyLanes];

void main() {
    uint lane = gl_LocalInvocationID.x, own = lane % push.lanes;
    uint p = ((gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * kTallyLanes + lane) / push.lanes;
    bool exists = p < push.patches;
    uvec2 range = exists ? fetch_patches(p).xy : uvec2(0u);
    Sum3 unshot = sum_start(), absorbed = sum_start();
    for (uint e = own; e < range.y; e += push.lanes) {
        uint i = range.x + e;
        vec4 surface = uintBitsToFloat(fetch_elements(kSolveElementTexels * i)); // rho, area
        vec4 a = uintBitsToFloat(fetch_state(kSolveStateTexels * i)), b = uintBitsToFloat(fetch_state(kSolveStateTexels * i + 1u));
        vec4 c = uintBitsToFloat(fetch_state(kSolveStateTexels * i + 2u));
        sum_add(unshot, surface.w * sum_result(Sum3(vec3(a.w, b.w, c.w), c.xyz)));
        sum_add(absorbed, surface.w * ((1.0 - surface.xyz) * sum_result(Sum3(a.xyz, b.xyz))));
    }
    unshot_of[lane] = sum_result(unshot), absorbed_of[lane] = sum_result(absorbed);
    for (uint reach = push.lanes >> 1u; reach > 0u; reach >>= 1u) {
        barrier();
        if (own < reach) unshot_of[lane] += unshot_of[lane + reach], absorbed_of[lane] += absorbed_of[lane + reach];
    }
    vec3 left = unshot_of[lane];
    if (exists && own == 0u) tally[p] = SolveTally(left, left.x + left.y + left.z, absorbed_of[lane], 0u);
}
