// How often each digit occurs in a lane's run. In: keys. Out: counts, a row of all lanes for each digit.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/sort.glsl"

layout(local_size_x = 64) in;
FETCH_TABLE(keys, FETCH_BUILD, 0)
layout(set = 0, binding = 2, scalar) writeonly buffer Counts { uint counts[]; };

uint counted[kDigits];

void main() {
    uint lane = gl_GlobalInvocationID.x, first = lane * push.chunk, end = min(first + push.chunk, push.count);
    for (uint d = 0u; d < kDigits; ++d) counted[d] = 0u;
    for (uint i = first; i < end; i += 4u) {
        uvec4 key = fetch_keys(i >> 2u);
        ++counted[digit_of(key.x)];
        counted[digit_of(key.y)] += uint(i + 1u < end);
        counted[digit_of(key.z)] += uint(i + 2u < end);
        counted[digit_of(key.w)] += uint(i + 3u < end);
    }
    for (uint d = 0u; d < kDigits; ++d) counts[d * push.lanes + lane] = counted[d];
}
