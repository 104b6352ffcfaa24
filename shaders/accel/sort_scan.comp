// Where each lane's elements of each digit go: the sum of all counts before, of smaller digits and of the same one in earlier lanes.
// In: counts. Out: offsets likewise. One work group, an invocation a digit. Hillis, Steele 1986, "Data parallel algorithms" (the sums).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/sort.glsl"

layout(local_size_x = 256) in;
FETCH_TABLE(counts, FETCH_BUILD, 0)
layout(set = 0, binding = 2, scalar) writeonly buffer Offsets { uvec4 offsets[]; };

shared uint sums[kSortDigits];

uint sum_of_row(uint first, uint end) {
    uvec4 sum = uvec4(0u);
    for (uint i = first; i < end; ++i) sum += fetch_counts(i);
    return sum.x + sum.y + sum.z + sum.w;
}

void main() {
    uint digit = gl_LocalInvocationID.x, first = digit * push.lanes / 4u, end = digit < kDigits ? first + push.lanes / 4u : first;
    uint own = sum_of_row(first, end), sum = own;
    sums[digit] = own;
    for (uint step = 1u; step < kDigits; step *= 2u) {
        barrier();
        uint before = digit >= step ? sums[digit - step] : 0u;
        barrier();
        sum += before;
        sums[digit] = sum;
    }
    uint at = sum - own;
    for (uint i = first; i < end; ++i) {
        uvec4 n = fetch_counts(i);
        offsets[i] = at + uvec4(0u, n.x, n.x + n.y, n.x + n.y + n.z);
        at += n.x + n.y + n.z + n.w;
    }
}
