// A block of rows of one sweep of Gauss and Seidel's iteration (S29; Golub and Van Loan 2013, "Matrix Computations", sec. 11.2): rows before
// the block count as they are after this sweep, all others as they were before it. A work group a row.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "fetch.glsl"
#include "lib/sum.glsl"
#include "shared/radiosity.h"
#include "shared/solve.h"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { SweepPush push; };
FETCH_TABLE(rows, FETCH_SOLVE_ROWS, 0)
FETCH_TABLE(before, FETCH_SOLVE_TABLES, 2)
FETCH_TABLE(done, FETCH_SOLVE_TABLES, 4)
FETCH_TABLE(sums, FETCH_SOLVE_TABLES, 6)
FETCH_TABLE(surfaces, FETCH_SOLVE_TABLES, 8)
layout(set = 0, binding = 10, scalar) writeonly buffer After { SolveRadiosity after[]; };

shared vec3 partial[64];

float form_factor(uint row, uint j) {
    uint at = row * push.elements + j;
    return float(fetch_rows(at >> 2u)[at & 3u]);
}

// Of all but the row's own element.
vec3 gathered(uint row, uint lane) {
    Sum3 sum = sum_start();
    for (uint j = lane; j < push.start; j += 64u) sum_add(sum, form_factor(row, j) * uintBitsToFloat(fetch_done(j).xyz));
    for (uint j = push.start + lane; j < push.elements; j += 64u)
        sum_add(sum, (j == row ? 0.0 : form_factor(row, j)) * uintBitsToFloat(fetch_before(j).xyz));
    return sum_result(sum);
}

void main() {
    uint row = push.start + gl_WorkGroupID.x, lane = gl_LocalInvocationID.x;
    partial[lane] = gathered(row, lane);
    barrier();
    if (lane != 0u) return;
    Sum3 all = sum_start();
    for (uint i = 0u; i < 64u; ++i) sum_add(all, partial[i]);
    float scale = uintBitsToFloat(fetch_sums(row).z) / float(kHemicubeOne);
    vec3 emission = uintBitsToFloat(fetch_surfaces(2u * row).xyz), rho = uintBitsToFloat(fetch_surfaces(2u * row + 1u).xyz);
    vec3 b = (emission + rho * (scale * sum_result(all))) / (1.0 - rho * (scale * form_factor(row, row)));
    vec3 change = abs(b - uintBitsToFloat(fetch_before(row).xyz));
    after[row] = SolveRadiosity(b, max(change.x, max(change.y, change.z)));
}
