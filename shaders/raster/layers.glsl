// Lists of translucent fragments (S13; after Carpenter 1984, "The A-buffer, an Antialiased Hidden Surface Method", with exact lists in place
// of masks). Eight by eight pixels are a block, and their records interlaced: what neighbours write lies together and in the order of
// drawing, where runs of single pixels, or of eight, would be scattered over memory.
//
// A record is one uvec4: the bits of the depth, the radiance. Storing is what costs (on lavapipe more than shading), so the opacity is left
// in the material, and the surface's number is stored in a table beside; only where a picture's alpha counts (EFFECT_TEXTURE_ALPHA) the opacity itself is.
#ifndef LIGHTBENCH_LAYERS_GLSL
#define LIGHTBENCH_LAYERS_GLSL

uint tile_pixel(uvec2 at, uint width) { return at.y * width + at.x; } // `at`: pixels from the tile's corner

uint block_at(uvec2 at, uint width) { return (at.y >> 3u) * ((width + 7u) >> 3u) + (at.x >> 3u); }

// `block`: (where its records begin, the most layers of its pixels, its pixels: 64, or 1 in a tile of one, 0).
uint record_of(uvec4 block, uint place, uvec2 at) { return block.x + place * block.z + ((at.y & 7u) << 3u | at.x & 7u); }

#endif
