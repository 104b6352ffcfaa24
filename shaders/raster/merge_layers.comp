// One level of a merge sort of the keys of pixels with many layers: each invocation merges two neighbouring runs of one pixel. At the first
// level the runs are single records. In: keys (or records), sorted in runs of push.run. Out: keys sorted in runs of twice that.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raster/blend.glsl"

layout(constant_id = CONSTANT_LAYERS) const uint kFirstLevel = 0u; // 1: from the records

FETCH_TABLE(deep_pixels, FETCH_LAYERS, 8)
FETCH_TABLE(keys_in, FETCH_LAYERS, 10)
layout(set = 0, binding = 12, scalar) writeonly buffer KeysOut { uvec4 keys_out[]; };

// Of the layer at a place of the list; keys lie where records do.
uvec2 read_key(List list, uint place) {
    uint record = record_of(list, min(place, list.n - 1u));
    if (kFirstLevel != 0u) return key_of(record);
    return fetch_keys_in(record).xy;
}

void main() {
    uint deep = invocation() / push.pairs, pair = invocation() % push.pairs;
    if (deep >= push.deep_count) return;
    deep += push.first_deep;
    List list = list_of(fetch_deep_pixels(deep >> 2u)[deep & 3u]);
    uint a = 2u * push.run * pair, a_end = min(a + push.run, list.n), b = a_end, b_end = min(b + push.run, list.n);
    if (a >= list.n) return;
    uvec2 from_a = read_key(list, a), from_b = read_key(list, b);
    for (uint place = a; place < b_end; ++place) {
        bool b_first = from_b.x > from_a.x;
        for (bool tie = a < a_end && b < b_end && from_a.x == from_b.x; tie; tie = false) b_first = looks_before(from_b.y, from_a.y);
        bool take_a = b >= b_end || (a < a_end && !b_first);
        keys_out[record_of(list, place)] = uvec4(take_a ? from_a : from_b, 0u, 0u);
        a += take_a ? 1u : 0u, b += take_a ? 0u : 1u;
        uvec2 next = read_key(list, take_a ? a : b);
        from_a = take_a ? next : from_a;
        from_b = take_a ? from_b : next;
    }
}
