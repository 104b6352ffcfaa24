// Mip chains: sizes, means, weights where areas cut through pixels. TX-7.
#include "image/mips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace lightbench {
namespace {

ImageF noise_of(unsigned width, unsigned height, float low, float high) {
    ImageF image{.width = width, .height = height, .rgba = {}};
    std::mt19937 random(width * 31 + height);
    image.rgba.resize(std::size_t{width} * height * 4);
    for (float& x : image.rgba) x = low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24f;
    return image;
}

std::array<double, 4> mean(const ImageF& image) {
    std::array<double, 4> sum{};
    for (std::size_t i = 0; i < image.rgba.size(); ++i) sum[i % 4] += static_cast<double>(image.rgba[i]);
    for (double& s : sum) s /= static_cast<double>(image.rgba.size() / 4);
    return sum;
}

// The share of [i, i + 1] of m that lies in [k, k + 1] of n, both stretched over the same length.
double overlap(unsigned n, unsigned m, unsigned i, unsigned k) {
    const double from = std::max(double(i) / m, double(k) / n), to = std::min((i + 1.0) / m, (k + 1.0) / n);
    return std::max(0.0, to - from) * m;
}

TEST(Mips, HalveDownToOnePixel) {
    const std::vector<ImageF> levels = mip_chain(noise_of(13, 4, 0, 1));
    std::vector<std::array<unsigned, 2>> sizes;
    for (const ImageF& level : levels) sizes.push_back({level.width, level.height});
    EXPECT_EQ(sizes, (std::vector<std::array<unsigned, 2>>{{13, 4}, {6, 2}, {3, 1}, {1, 1}}));
    EXPECT_EQ(mip_chain(noise_of(1, 1, 0, 1)).size(), 1u);
    EXPECT_EQ(mip_chain(noise_of(1, 9, 0, 1)).size(), 4u);
}

TEST(Mips, PixelsAreMeansOverTheirAreas) {
    for (const auto& [width, height] : {std::array{7u, 5u}, {8u, 3u}, {1u, 6u}, {2u, 2u}, {15u, 1u}, {9u, 16u}}) {
        const std::vector<ImageF> levels = mip_chain(noise_of(width, height, -1, 1));
        for (std::size_t l = 1; l < levels.size(); ++l) {
            const ImageF &in = levels[l - 1], &out = levels[l];
            for (unsigned y = 0; y < out.height; ++y)
                for (unsigned x = 0; x < out.width; ++x) {
                    double sum = 0;
                    for (unsigned j = 0; j < in.height; ++j)
                        for (unsigned i = 0; i < in.width; ++i)
                            sum += overlap(in.height, out.height, y, j) * overlap(in.width, out.width, x, i) *
                                   static_cast<double>(in.at(i, j)[1]);
                    ASSERT_NEAR(static_cast<double>(out.at(x, y)[1]), sum, 0x1p-24) << width << "x" << height << " level " << l;
                }
        }
    }
}

TEST(Mips, MeanIsPreserved) {
    for (const auto& [width, height] :
         {std::array{1u, 1u}, {1u, 1000u}, {777u, 1u}, {255u, 257u}, {640u, 360u}, {1023u, 511u}, {16383u, 3u}}) {
        const ImageF image = noise_of(width, height, 0, 1);
        const std::array<double, 4> whole = mean(image);
        for (const ImageF& level : mip_chain(image)) {
            const std::array<double, 4> here = mean(level);
            for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(here[c], whole[c], 1e-6) << width << "x" << height << " at " << level.width;
        }
    }
}

TEST(Mips, ConstantsStay) {
    ImageF image{.width = 11, .height = 6, .rgba = std::vector<float>(11 * 6 * 4, 0.3f)};
    for (const ImageF& level : mip_chain(image))
        for (float x : level.rgba) EXPECT_NEAR(x, 0.3f, 0x1p-25f);
}

} // namespace
} // namespace lightbench
