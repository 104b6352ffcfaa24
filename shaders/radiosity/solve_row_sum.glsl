// The exact sum of a row of form factors by a work group. In: uvec4 fetch_rows(uint), declared by the includer, and kRowLanes lanes, each at
// most 2^16 of a row's texels. Out: the sum in two halves, to lane 0.
#ifndef LIGHTBENCH_RADIOSITY_SOLVE_ROW_SUM_GLSL
#define LIGHTBENCH_RADIOSITY_SOLVE_ROW_SUM_GLSL
#include "shared/radiosity.h"
#include "shared/solve.h"

const uint kRowLanes = 128u;
shared uvec2 row_partial[kRowLanes];

// Entries of texel t that lie in [first, end); the others are another row's.
uvec4 own_entries(uint t, uint first, uint end) {
    uvec4 at = 4u * t + uvec4(0u, 1u, 2u, 3u);
    bvec4 own = bvec4(uvec4(greaterThanEqual(at, uvec4(first))) & uvec4(lessThan(at, uvec4(end))));
    return mix(uvec4(0u), fetch_rows(t), own);
}

// Halves of 16 bits: a lane's sums stay below 2^32 though the row's may not. Every lane must come here.
SolveRowSum sum_row(uint first, uint count, uint lane) {
    uvec2 sum = uvec2(0u);
    for (uint t = (first >> 2u) + lane; 4u * t < first + count; t += kRowLanes) {
        uvec4 f = own_entries(t, first, first + count);
        uvec4 low = f & 0xffffu, high = f >> 16u;
        sum += uvec2(high.x + high.y + high.z + high.w, low.x + low.y + low.z + low.w);
        sum = uvec2(sum.x + (sum.y >> 16u), sum.y & 0xffffu);
    }
    row_partial[lane] = sum;
    barrier();
    uvec2 total = uvec2(0u);
    if (lane == 0u)
        for (uint i = 0u; i < kRowLanes; ++i) total += row_partial[i];
    total = uvec2(total.x + (total.y >> 16u), total.y & 0xffffu);
    const uint one = kHemicubeOne >> 16u;
    bool above = total.x > one || (total.x == one && total.y > 0u);
    float scale = above ? float(kHemicubeOne) / (65536.0 * float(total.x) + float(total.y)) : 1.0;
    return SolveRowSum(total.x, total.y, scale, 0u);
}

#endif
