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

uvec2 tile_pixel(uint i, uvec2 size) {
    uvec2 whole = uvec2(size.x & ~3u, size.y & ~1u);
    uint blocks = whole.x * whole.y, right = (size.x - whole.x) * size.y;
    if (i < blocks) {
        uint block = i >> 3u, columns = whole.x >> 2u;
        return divide(block, columns) * uvec2(4u, 2u) + uvec2(i & 3u, i >> 2u & 1u);
    }
    uint left = i - blocks;
    if (left < right) return uvec2(whole.x, 0u) + divide(left, size.x - whole.x);
    left -= right;
    return uvec2(0u, whole.y) + divide(left, whole.x);
}

#endif
