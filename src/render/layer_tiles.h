// Where the lists of translucent fragments of an image do not fit into one buffer, the image is cut into tiles. Pure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lightbench {

struct LayerTile {
    std::uint32_t x = 0, y = 0, width = 0, height = 0; // pixels, within the area that was counted
    std::uint64_t layers = 0;                          // of all its pixels
    std::uint32_t most = 0;                            // of one pixel
};

// `counts` are layers by pixel, rows of `width`. Whole rows where a row fits into `capacity` layers, else parts of one row; tiles without
// any layer are left out. A pixel that alone exceeds the capacity becomes a tile of its own, which the caller must refuse.
std::vector<LayerTile> cut_into_tiles(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint64_t capacity);

} // namespace lightbench
