// Which pixel of a tile a sample belongs to: blocks of 4 x 2 pixels one after the other, so that the eight rays of a SIMD group go together;
// then what the blocks leave over at the right and at the bottom.
#ifndef LIGHTBENCH_RAYTRACE_TILE_GLSL
#define LIGHTBENCH_RAYTRACE_TILE_GLSL

// Quotient and rest, for a < 2^24: CPU drivers divide integers one lane after the other. The float quotient is off by one at most.
uvec2 divide(uint a, uint b) {
    uint q = uint(float(a) / float(b));
    q -= uint(q * b > a);
    q += uint(a - q * b >= b);
    return uvec2(a - q * b, q);
}

// One division whichever part the sample lies in: CPU drivers would do all three.
uvec2 tile_pixel(uint i, uvec2 size) {
    uvec2 whole = uvec2(size.x & ~3u, size.y & ~1u);
    uint blocks = whole.x * whole.y, right = (size.x - whole.x) * size.y;
    bool in_block = i < blocks, beside = i - blocks < right;
    uint place = in_block ? i >> 3u : beside ? i - blocks : i - blocks - right;
    uvec2 at = divide(place, in_block ? whole.x >> 2u : beside ? size.x - whole.x : whole.x);
    if (in_block) return at * uvec2(4u, 2u) + uvec2(i & 3u, i >> 2u & 1u);
    return at + (beside ? uvec2(whole.x, 0u) : uvec2(0u, whole.y));
}

#endif
