// Elements go to where their digits belong; those of equal digits stay in order. In: keys, values, offsets. Out: both in the new order, or
// where each has gone.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/sort.glsl"

layout(local_size_x = 64) in;
layout(constant_id = CONSTANT_SORT_MOVE) const uint kMove = 7u;
FETCH_TABLE(keys, FETCH_BUILD, 0)
FETCH_TABLE(values, FETCH_BUILD, 2)
FETCH_TABLE(offsets, FETCH_BUILD, 4)
layout(set = 0, binding = 6, scalar) writeonly buffer MovedKeys { uint moved_keys[]; };
layout(set = 0, binding = 7, scalar) writeonly buffer MovedValues { uint moved_values[]; };
layout(set = 0, binding = 8, scalar) writeonly buffer Ranks { uint ranks[]; };

uint next[kDigits];

void move(uint i, uint key, uint value) {
    uint digit = digit_of(key), to = next[digit];
    next[digit] = to + 1u;
    if ((kMove & MOVE_KEYS) != 0u) moved_keys[to] = key;
    moved_values[to] = value;
    if ((kMove & MOVE_RANKS) != 0u) ranks[i] = to;
}

void main() {
    uint lane = gl_GlobalInvocationID.x, first = lane * push.chunk, end = min(first + push.chunk, push.count);
    for (uint d = 0u; d < kDigits; ++d) {
        uint at = d * push.lanes + lane;
        uvec4 texel = fetch_offsets(at >> 2u);
        next[d] = (at & 2u) != 0u ? ((at & 1u) != 0u ? texel.w : texel.z) : ((at & 1u) != 0u ? texel.y : texel.x);
    }
    for (uint i = first; i < end; i += 4u) {
        uvec4 key = fetch_keys(i >> 2u), value = i + uvec4(0u, 1u, 2u, 3u);
        if ((kMove & MOVE_VALUES) != 0u) value = fetch_values(i >> 2u);
        move(i, key.x, value.x);
        if (i + 1u < end) move(i + 1u, key.y, value.y);
        if (i + 2u < end) move(i + 2u, key.z, value.z);
        if (i + 3u < end) move(i + 3u, key.w, value.w);
    }
}
