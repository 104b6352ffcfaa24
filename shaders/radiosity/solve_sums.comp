// Sums of all rows of a full matrix (S29). A work group a row.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "fetch.glsl"
#include "shared/solve.h"

layout(local_size_x = 128) in;
layout(push_constant, scalar) uniform Push { SweepPush push; };
FETCH_TABLE(rows, FETCH_SOLVE_ROWS, 0)
layout(set = 0, binding = 2, scalar) writeonly buffer Sums { SolveRowSum sums[]; };
#include "radiosity/solve_row_sum.glsl"

void main() {
    uint lane = gl_LocalInvocationID.x;
    SolveRowSum sum = sum_row(gl_WorkGroupID.x * push.elements, push.elements, lane);
    if (lane == 0u) sums[gl_WorkGroupID.x] = sum;
}
