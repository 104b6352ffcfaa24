// Blends pixels of few layers: their keys are sorted in registers by a network. In: the tile's layers. Out: radiance with them in front.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raster/blend.glsl"

layout(constant_id = CONSTANT_LAYERS) const uint kMost = 4u; // layers: 2, 4, 8 or 16

// Every index is a constant, written out: what is indexed in a loop lives in memory, and costs ten times as much (lavapipe).
uvec2 keys[16];

#define ORDER(A, B)                                   \
    {                                                 \
        uvec2 x = keys[A], y = keys[B];               \
        bool swap = y.x > x.x;                        \
        keys[A] = swap ? y : x, keys[B] = swap ? x : y; \
    }
// Batcher 1968, "Sorting Networks and their Applications": odd-even merge sort.
#define SORT2(F) ORDER(F, F + 1)
#define SORT4(F) SORT2(F) SORT2(F + 2) ORDER(F, F + 2) ORDER(F + 1, F + 3) ORDER(F + 1, F + 2)
#define SORT8(F)                                                                                              \
    SORT4(F) SORT4(F + 4)                                                                                     \
    ORDER(F, F + 4) ORDER(F + 1, F + 5) ORDER(F + 2, F + 6) ORDER(F + 3, F + 7)                               \
    ORDER(F + 2, F + 4) ORDER(F + 3, F + 5) ORDER(F + 1, F + 2) ORDER(F + 3, F + 4) ORDER(F + 5, F + 6)
#define SORT16                                                                                                \
    SORT8(0) SORT8(8)                                                                                         \
    ORDER(0, 8) ORDER(1, 9) ORDER(2, 10) ORDER(3, 11) ORDER(4, 12) ORDER(5, 13) ORDER(6, 14) ORDER(7, 15)     \
    ORDER(4, 8) ORDER(5, 9) ORDER(6, 10) ORDER(7, 11)                                                         \
    ORDER(2, 4) ORDER(3, 5) ORDER(6, 8) ORDER(7, 9) ORDER(10, 12) ORDER(11, 13)                               \
    ORDER(1, 2) ORDER(3, 4) ORDER(5, 6) ORDER(7, 8) ORDER(9, 10) ORDER(11, 12) ORDER(13, 14)

uvec2 read_key(uint k, List list) { return k < list.n ? key_of(record_of(list, k)) : uvec2(0u); }
#define READ(K) keys[K] = read_key(K, list);
#define READ4(F) READ(F) READ(F + 1) READ(F + 2) READ(F + 3)
#define BLEND(K) if (K < list.n) blend_layer(b, keys[K].y);
#define BLEND4(F) BLEND(F) BLEND(F + 1) BLEND(F + 2) BLEND(F + 3)

#define EACH_PAIR(DO)                                        \
    DO(0)                                                    \
    if (kMost > 2u) { DO(1) DO(2) }                          \
    if (kMost > 4u) { DO(3) DO(4) DO(5) DO(6) }              \
    if (kMost > 8u) { DO(7) DO(8) DO(9) DO(10) DO(11) DO(12) DO(13) DO(14) }
#define IS_TIED(K) tied = tied || (K + 1 < list.n && keys[K].x == keys[K + 1].x);
#define EXCHANGE(K)                                                                                                  \
    if (K + 1 < list.n && keys[K].x == keys[K + 1].x && looks_before(keys[K + 1].y, keys[K].y)) {                    \
        uvec2 x = keys[K];                                                                                           \
        keys[K] = keys[K + 1], keys[K + 1] = x;                                                                      \
    }

// Neighbours of one depth change places until they are in order; a loop that nobody enters costs nothing.
void order_ties(List list) {
    bool tied = false;
    EACH_PAIR(IS_TIED)
    for (uint pass = 0u; pass < (tied ? kMost : 0u); ++pass) { EACH_PAIR(EXCHANGE) }
}

void main() {
    uint i = invocation();
    if (i >= push.size.x * push.size.y) return;
    List list = list_of(i);
    if (list.n == 0u || list.n > kMost) return;
    Blend b = Blend(vec3(0.0), vec3(1.0));
    READ(0) READ(1)
    if (kMost > 2u) { READ(2) READ(3) }
    if (kMost > 4u) READ4(4)
    if (kMost > 8u) { READ4(8) READ4(12) }
    if (kMost == 2u) { SORT2(0) }
    if (kMost == 4u) { SORT4(0) }
    if (kMost == 8u) { SORT8(0) }
    if (kMost == 16u) { SORT16 }
    order_ties(list);
    BLEND(0) BLEND(1)
    if (kMost > 2u) { BLEND(2) BLEND(3) }
    if (kMost > 4u) { BLEND4(4) }
    if (kMost > 8u) { BLEND4(8) BLEND4(12) }
    finish(list, b);
}
