// Tiles of translucent fragments: every pixel with layers in exactly one tile, none beyond the capacity unless it is a pixel alone.
#include "render/layer_tiles.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <random>

namespace lightbench {
namespace {

void expect_cover(const std::vector<std::uint32_t>& counts, std::uint32_t width, std::uint64_t capacity) {
    std::vector<int> covered(counts.size(), 0);
    for (const LayerTile& t : cut_into_tiles(counts, width, capacity)) {
        std::uint64_t layers = 0;
        std::uint32_t most = 0;
        for (std::uint32_t y = t.y; y < t.y + t.height; ++y)
            for (std::uint32_t x = t.x; x < t.x + t.width; ++x) {
                const std::size_t at = std::size_t{y} * width + x;
                ++covered.at(at);
                layers += counts[at], most = std::max(most, counts[at]);
            }
        EXPECT_GE(t.records, layers);
        EXPECT_LE(t.records, std::uint64_t{most} * (t.width + kBlock) * (t.height + kBlock));
        EXPECT_EQ(most, t.most);
        EXPECT_GT(layers, 0u);
        if (t.records > capacity) {
            EXPECT_EQ(t.width * t.height, 1u);
            EXPECT_EQ(t.records, layers);
        }
    }
    for (std::size_t i = 0; i < counts.size(); ++i) EXPECT_TRUE(covered[i] == 1 || (covered[i] == 0 && counts[i] == 0)) << i;
}

TEST(LayerTiles, CoverWhatHasLayersOnce) {
    std::mt19937 random(3);
    for (const std::uint32_t width : {1u, 7u, 8u, 21u, 64u})
        for (const std::uint64_t capacity : {1u, 5u, 40u, 600u, 1000000u}) {
            std::vector<std::uint32_t> counts(std::size_t{width} * 13);
            for (auto& n : counts) n = random() % 3 == 0 ? random() % 9 : 0;
            expect_cover(counts, width, capacity);
        }
}

TEST(LayerTiles, OneTileWhereAllFits) {
    const std::vector<std::uint32_t> counts{0, 0, 1, 2, 0, 3};
    const auto tiles = cut_into_tiles(counts, 2, 192);
    ASSERT_EQ(tiles.size(), 1u);
    EXPECT_EQ(tiles[0].records, 192u) << "a block with room for 3 layers each";
    EXPECT_EQ(tiles[0].height, 3u);
    EXPECT_TRUE(cut_into_tiles(std::vector<std::uint32_t>(6, 0), 2, 192).empty());
}

} // namespace
} // namespace lightbench
