// Blends pixels of many layers, whose keys were sorted before. In: the tile's layers and keys. Out: radiance with them in front.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raster/blend.glsl"

FETCH_TABLE(deep_pixels, FETCH_LAYERS, 8)
FETCH_TABLE(keys_in, FETCH_LAYERS, 10)

void main() {
    uint deep = invocation();
    if (deep >= push.deep_count) return;
    deep += push.first_deep;
    List list = list_of(fetch_deep_pixels(deep >> 2u)[deep & 3u]);
    Blend b = Blend(vec3(0.0), vec3(1.0));
    uint k = 0u;
    for (; k < list.n; ++k) blend_layer(b, fetch_keys_in(record_of(list, k)).y);
    if (k != list.n) b.sum = vec3(uintBitsToFloat(0x7fc00000u)); // a driver that ended the loop early is found out by the census
    finish(list, b);
}
