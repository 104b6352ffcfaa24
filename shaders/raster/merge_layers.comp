// One level of a merge sort of the keys of pixels with many layers: each invocation merges two neighbouring runs of one pixel. At the first
// level the runs are single records. In: keys (or records), sorted in runs of push.run. Out: keys sorted in runs of twice that.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raster/blend.glsl"

layout(constant_id = CONSTANT_LAYERS) const uint kFirstLevel = 0u; // 1: from the records

FETCH_TABLE(deep_pixels, FETCH_LAYERS, 6)
FETCH_TABLE(keys_in, FETCH_LAYERS, 8)
layout(set = 0, binding = 10, scalar) writeonly buffer KeysOut { uvec4 keys_out[]; };

// (depth, tie, record)
uvec3 read_key(uint at) {
    if (kFirstLevel != 0u) return uvec3(fetch_layers(kRecordWords * at).xy, at);
    return fetch_keys_in(at).xyz;
}

void main() {
    uint deep = invocation() / push.pairs, pair = invocation() % push.pairs;
    if (deep >= push.deep_count) return;
    uint i = fetch_deep_pixels(deep >> 2u)[deep & 3u];
    uint first = offset_of(i), end = offset_of(i + 1u);
    uint a = first + 2u * push.run * pair, a_end = min(a + push.run, end), b = a_end, b_end = min(b + push.run, end);
    if (a >= end) return;
    uvec3 from_a = read_key(a), from_b = read_key(min(b, end - 1u));
    for (uint out_at = a; out_at < b_end; ++out_at) {
        bool take_a = b >= b_end || (a < a_end && !before(from_b.xy, from_a.xy));
        keys_out[out_at] = uvec4(take_a ? from_a : from_b, 0u);
        a += take_a ? 1u : 0u, b += take_a ? 0u : 1u;
        uvec3 next = read_key(min(take_a ? a : b, end - 1u));
        from_a = take_a ? next : from_a;
        from_b = take_a ? from_b : next;
    }
}
