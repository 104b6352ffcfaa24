// Blends pixels of few layers: their keys are sorted in registers by a network. In: the tile's layers. Out: radiance with them in front.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#extension GL_EXT_control_flow_attributes : require
#include "raster/blend.glsl"

layout(constant_id = CONSTANT_LAYERS) const uint kMost = 4u; // layers, a power of two

uvec3 keys[16];

void order(uint a, uint b) {
    uvec3 x = keys[a], y = keys[b];
    bool swap = before(y.xy, x.xy);
    keys[a] = swap ? y : x;
    keys[b] = swap ? x : y;
}

// Batcher 1968, "Sorting Networks and their Applications": odd-even merge sort, all indices constant.
void sort_keys() {
    [[unroll]] for (uint p = 1u; p < kMost; p *= 2u)
        [[unroll]] for (uint k = p; k >= 1u; k /= 2u)
            [[unroll]] for (uint j = k % p; j + k < kMost; j += 2u * k)
                [[unroll]] for (uint i = 0u; i < k; ++i)
                    if (i + j + k < kMost && (i + j) / (2u * p) == (i + j + k) / (2u * p)) order(i + j, i + j + k);
}

void main() {
    uint i = invocation();
    if (i >= push.size.x * push.size.y) return;
    uint first = offset_of(i), n = offset_of(i + 1u) - first;
    if (n == 0u || n > kMost) return;
    [[unroll]] for (uint k = 0u; k < kMost; ++k) {
        uvec2 key = k < n ? fetch_layers(kRecordWords * (first + k)).xy : uvec2(0u, 0xffffffffu);
        keys[k] = uvec3(key, first + k);
    }
    sort_keys();
    Blend b = Blend(vec3(0.0), vec3(1.0));
    for (uint k = 0u; k < n; ++k) blend_layer(b, keys[k].z);
    finish(i, b, n);
}
