#include "render/layer_tiles.h"

#include <algorithm>

namespace lightbench {
namespace {

class Cutter {
  public:
    Cutter(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint64_t capacity)
        : counts_(counts), width_(width), height_(static_cast<std::uint32_t>(counts.size() / width)), capacity_(capacity) {}
    std::vector<LayerTile> run();

  private:
    LayerTile part(std::uint32_t y, std::uint32_t x, std::uint32_t end) const;
    void cut_row(std::uint32_t y);
    void cut_block(std::uint32_t y, std::uint32_t x);
    void keep(const LayerTile& tile) {
        if (tile.records > 0) tiles_.push_back(tile);
    }

    std::span<const std::uint32_t> counts_;
    std::uint32_t width_, height_;
    std::uint64_t capacity_;
    std::vector<LayerTile> tiles_;
};

// The blocks from x to `end` of the row of blocks at y.
LayerTile Cutter::part(std::uint32_t y, std::uint32_t x, std::uint32_t end) const {
    LayerTile tile{x, y, end - x, std::min(kBlock, height_ - y), 0, 0};
    for (; x < end; x += kBlock) {
        const std::uint32_t most = most_in_block(counts_, width_, x, y, end, y + tile.height);
        tile.records += std::uint64_t{most} * pixels_of_block(tile);
        tile.most = std::max(tile.most, most);
    }
    return tile;
}

void Cutter::cut_block(std::uint32_t y, std::uint32_t x) {
    for (std::uint32_t v = y; v < std::min(y + kBlock, height_); ++v)
        for (std::uint32_t u = x; u < std::min(x + kBlock, width_); ++u) {
            const std::uint32_t n = counts_[std::size_t{v} * width_ + u];
            keep({u, v, 1, 1, n, n});
        }
}

// As many blocks as fit; a block that does not fit alone by its pixels.
void Cutter::cut_row(std::uint32_t y) {
    const auto next = [&](std::uint32_t x) { return std::min(x + kBlock, width_); };
    for (std::uint32_t x = 0; x < width_;) {
        LayerTile tile = part(y, x, next(x));
        if (tile.records > capacity_) {
            cut_block(y, x);
            x = next(x);
            continue;
        }
        for (x = next(x); x < width_; x = next(x)) {
            const LayerTile more = part(y, x, next(x));
            if (tile.records + more.records > capacity_) break;
            tile.width += more.width, tile.records += more.records, tile.most = std::max(tile.most, more.most);
        }
        keep(tile);
    }
}

std::vector<LayerTile> Cutter::run() {
    bool open = false; // the last tile takes further rows
    for (std::uint32_t y = 0; y < height_; y += kBlock) {
        const LayerTile row = part(y, 0, width_);
        if (row.records > capacity_) {
            cut_row(y);
            open = false;
        } else if (open && tiles_.back().records + row.records <= capacity_) {
            LayerTile& tile = tiles_.back();
            tile.height += row.height, tile.records += row.records, tile.most = std::max(tile.most, row.most);
        } else if (row.records > 0) {
            tiles_.push_back(row);
            open = true;
        }
    }
    return std::move(tiles_);
}

} // namespace

std::uint32_t pixels_of_block(const LayerTile& tile) {
    return tile.width == 1 && tile.height == 1 ? 1 : kBlock * kBlock;
}

std::uint32_t most_in_block(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint32_t x, std::uint32_t y,
                            std::uint32_t end_x, std::uint32_t end_y) {
    std::uint32_t most = 0;
    for (std::uint32_t v = y; v < std::min(y + kBlock, end_y); ++v)
        for (std::uint32_t u = x; u < std::min(x + kBlock, end_x); ++u) most = std::max(most, counts[std::size_t{v} * width + u]);
    return most;
}

std::vector<LayerTile> cut_into_tiles(std::span<const std::uint32_t> counts, std::uint32_t width, std::uint64_t capacity) {
    return Cutter(counts, width, capacity).run();
}

} // namespace lightbench
