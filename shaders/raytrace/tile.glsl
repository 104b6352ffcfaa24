// Which pixel of a tile a sample belongs to: blocks of 4 x 2 pixels one after the other, so that the eight rays of a SIMD group go together;
// then what the blocks leave over at the right and at the bottom.
#ifndef LIGHTBENCH_RAYTRACE_TILE_GLSL
#define LIGHTBENCH_RAYTRACE_TILE_GLSL

uvec2 tile_pixel(uint i, uvec2 size) {
    uvec2 whole = uvec2(size.x & ~3u, size.y & ~1u);
    uint blocks = whole.x * whole.y, right = (size.x - whole.x) * size.y;
    if (i < blocks) {
        uint block = i >> 3u, columns = whole.x >> 2u;
        return uvec2((block % columns) * 4u + (i & 3u), (block / columns) * 2u + (i >> 2u & 1u));
    }
    uint left = i - blocks;
    if (left < right) return uvec2(whole.x + left % (size.x - whole.x), left / (size.x - whole.x));
    left -= right;
    return uvec2(left % whole.x, whole.y + left / whole.x);
}

#endif
