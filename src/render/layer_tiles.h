// Where the lists of translucent fragments of an image do not fit into one buffer, the image is cut into tiles. Pure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lightbench {

// Side of the squares of pixels whose records are interlaced (shaders/raster/layers.glsl): each pixel has room for as many layers as the one
// that has most. A tile of one pixel is a block of one.
constexpr std::uint32_t kBlock = 8;

struct LayerTile {
    std::uint32_t x = 0, y = 0, width = 0, height = 0; // pixels, within the area that was counted
    std::uint64_t records = 0;                         // room for all its blocks
    std::uint32_t most = 0;                            // layers of one pixel
};

std::uint32_t pixels_of_block(const LayerTile& tile);

// Of `counts`, rows of `width`: the largest of the block at (x, y), which ends before (end_x, end_y).
std::uint32_t most_in_block(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint32_t x, std::uint32_t y,
                            std::uint32_t end_x, std::uint32_t end_y);

// `counts` are layers by pixel. Whole rows of blocks where one fits into `capacity` records, else whole blocks of one row, else single
// pixels; tiles without any layer are left out. A pixel that alone exceeds the capacity is a tile that the caller must refuse.
std::vector<LayerTile> cut_into_tiles(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint64_t capacity);

} // namespace lightbench
