#include "render/layer_tiles.h"

#include <algorithm>
#include <numeric>

namespace lightbench {
namespace {

LayerTile row_part(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint32_t y, std::uint32_t x, std::uint32_t end) {
    const auto part = counts.subspan(std::size_t{y} * width + x, end - x);
    return {x, y, end - x, 1, std::accumulate(part.begin(), part.end(), std::uint64_t{0}), *std::ranges::max_element(part)};
}

void cut_row(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint32_t y, std::uint64_t capacity,
             std::vector<LayerTile>& out) {
    for (std::uint32_t x = 0; x < width;) {
        std::uint32_t end = x;
        std::uint64_t sum = 0;
        while (end < width && (end == x || sum + counts[std::size_t{y} * width + end] <= capacity))
            sum += counts[std::size_t{y} * width + end++];
        if (sum > 0) out.push_back(row_part(counts, width, y, x, end));
        x = end;
    }
}

} // namespace

std::vector<LayerTile> cut_into_tiles(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint64_t capacity) {
    std::vector<LayerTile> tiles;
    bool open = false; // the last tile takes further rows
    for (std::uint32_t y = 0; std::size_t{y} * width < counts.size(); ++y) {
        const LayerTile row = row_part(counts, width, y, 0, width);
        if (row.layers > capacity) {
            cut_row(counts, width, y, capacity, tiles);
            open = false;
            continue;
        }
        if (row.layers == 0 && !open) continue;
        if (open && tiles.back().layers + row.layers <= capacity) {
            LayerTile& tile = tiles.back();
            tile.height += 1, tile.layers += row.layers, tile.most = std::max(tile.most, row.most);
        } else if (row.layers > 0) {
            tiles.push_back(row);
            open = true;
        }
    }
    return tiles;
}

} // namespace lightbench
