// The table of pictures: where things are, what halves they become.
#include "image/display.h"
#include "image/mips.h"
#include "image/texels.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace lightbench {
namespace {

using namespace gpu_layout;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// IEEE 754-2008, 3.4: what 16 bits mean.
double from_half(std::uint32_t h) {
    const int exponent = static_cast<int>(h >> 10 & 31), fraction = static_cast<int>(h & 1023);
    if (exponent == 31) return fraction ? std::nan("") : (h >> 15 ? -1.0 : 1.0) * static_cast<double>(kInfinity);
    const double magnitude = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    return h >> 15 ? -magnitude : magnitude;
}

double stored(const TexelTable& table, const TexelInfo& t, unsigned level, unsigned x, unsigned y, unsigned channel) {
    const unsigned width = std::max(1u, t.width >> level), start = table.words[t.first + level / 4][level % 4];
    const std::uint32_t word = table.words.at(start + y * ((width + 1) / 2) + x / 2)[x % 2 * 2 + channel / 2];
    return from_half(channel % 2 ? word >> 16 : word & 0xffff) * std::ldexp(1.0, static_cast<int>(t.flags >> 16) - 128);
}

ImageF noise_of(unsigned width, unsigned height, float range) {
    ImageF image{.width = width, .height = height, .rgba = {}};
    std::mt19937 random(width + height);
    for (unsigned i = 0; i < width * height * 4; ++i) image.rgba.push_back(range * (static_cast<float>(random() >> 8) * 0x1p-23f - 1));
    return image;
}

TEST(Texels, EveryHalfStaysItself) {
    for (std::uint32_t h = 0; h < 0x10000; ++h) {
        const bool nan = (h & 0x7fff) > 0x7c00;
        const std::uint16_t back = half_from_float(static_cast<float>(from_half(h)));
        if (nan)
            EXPECT_GT(back & 0x7fff, 0x7c00);
        else
            EXPECT_EQ(back, h);
    }
}

// Between two neighbouring halves: the nearer one, and at the very middle the even one.
TEST(Texels, HalvesAreTheNearest) {
    for (std::uint32_t h = 0; h < 0x7c00; ++h) {
        const double low = from_half(h), high = h == 0x7bff ? 65536 : from_half(h + 1);
        const auto middle = static_cast<float>((low + high) / 2); // exact: eleven bits and one
        EXPECT_EQ(half_from_float(middle), h % 2 ? h + 1 : h) << h;
        EXPECT_EQ(half_from_float(std::nextafter(middle, 0.0f)), h) << h;
        EXPECT_EQ(half_from_float(std::nextafter(middle, kInfinity)), h + 1) << h;
        EXPECT_EQ(half_from_float(-middle), 0x8000u | (h % 2 ? h + 1 : h)) << h;
    }
    for (float x : {65520.0f, 1e30f, kInfinity}) EXPECT_EQ(half_from_float(x), 0x7c00);
    EXPECT_EQ(half_from_float(-kInfinity), 0xfc00);
    EXPECT_EQ(half_from_float(1e-45f), 0);
}

TEST(Texels, LayoutIsAsStated) {
    TexelTable table;
    table.add(noise_of(3, 3, 1), false, kWrapRepeat, kWrapRepeat);
    const std::size_t before = table.words.size();
    EXPECT_EQ(before, 1u + 3 * 2 + 1);
    const ImageF image = noise_of(37, 18, 100);
    const TexelInfo t = table.add(image, false, kWrapClamp, kWrapMirror);
    EXPECT_EQ(t.first, before);
    EXPECT_EQ(t.width, 37u);
    EXPECT_EQ(t.height, 18u);
    EXPECT_EQ(t.flags & 0xffff, 6u | kWrapClamp << 8 | kWrapMirror << 10);
    const std::vector<ImageF> levels = mip_chain(image);
    std::size_t words = before + 2; // six levels: two words of header
    for (unsigned l = 0; l < 6; ++l) {
        EXPECT_EQ(table.words[t.first + l / 4][l % 4], words);
        words += (levels[l].width + 1) / 2 * levels[l].height;
        for (unsigned y = 0; y < levels[l].height; ++y)
            for (unsigned x = 0; x < levels[l].width; ++x)
                for (unsigned c = 0; c < 4; ++c)
                    EXPECT_NEAR(stored(table, t, l, x, y, c), levels[l].at(x, y)[c], std::abs(levels[l].at(x, y)[c]) * 0x1p-11 + 1e-6);
    }
    EXPECT_EQ(table.words.size(), words);
}

// Beyond half's range, and far below it: eleven bits of the brightest pixel, and of what is a millionth of it.
TEST(Texels, AnyRangeIsStored) {
    for (const float peak : {1e30f, 1e6f, 65504.0f, 1.0f, 1e-3f, 1e-30f}) {
        TexelTable table;
        const TexelInfo t = table.add(ImageF{.width = 2, .height = 1, .rgba = {peak, 0, -peak, 1e-6f * peak, peak, 0, 0, 0}}, true, 0, 0);
        EXPECT_NEAR(stored(table, t, 0, 0, 0, 0) / static_cast<double>(peak), 1, 0x1p-11);
        EXPECT_NEAR(stored(table, t, 0, 0, 0, 2) / static_cast<double>(peak), -1, 0x1p-11);
        EXPECT_NEAR(stored(table, t, 0, 0, 0, 3) / static_cast<double>(peak), 1e-6, 1e-6 * 0x1p-11);
        EXPECT_EQ(stored(table, t, 0, 1, 0, 1), 0);
    }
}

TEST(Texels, WhatIsNotANumberStaysSo) {
    TexelTable table;
    const TexelInfo t = table.add(ImageF{.width = 1, .height = 1, .rgba = {kInfinity, std::nanf(""), 0.5f, 1}}, true, 0, 0);
    EXPECT_TRUE(std::isinf(stored(table, t, 0, 0, 0, 0)));
    EXPECT_TRUE(std::isnan(stored(table, t, 0, 0, 0, 1)));
    EXPECT_EQ(stored(table, t, 0, 0, 0, 2), 0.5);
}

// Colors are decoded, data and alpha are not; 1/26 of an sRGB step is the most that halves lose.
TEST(Texels, BytesAreDecodedOnce) {
    Image8 image{.width = 256, .height = 1, .rgba = {}};
    for (unsigned v = 0; v < 256; ++v)
        for (unsigned c = 0; c < 4; ++c) image.rgba.push_back(static_cast<std::uint8_t>(v));
    TexelTable table;
    const TexelInfo color = table.add(image, true, 0, 0), data = table.add(image, false, 0, 0);
    for (unsigned v = 0; v < 256; ++v) {
        EXPECT_NEAR(255 * srgb_from_linear(static_cast<float>(stored(table, color, 0, v, 0, 1))), v, 1 / 26.0);
        EXPECT_NEAR(stored(table, color, 0, v, 0, 3), v / 255.0, 0x1p-12);
        EXPECT_NEAR(stored(table, data, 0, v, 0, 0), v / 255.0, 0x1p-12);
    }
}

// Slopes of u + 2 v: the same everywhere but across the borders, which each wrap sees otherwise.
TEST(Texels, HeightSlopes) {
    ImageF plane{.width = 4, .height = 3, .rgba = {}};
    for (unsigned y = 0; y < 3; ++y)
        for (unsigned x = 0; x < 4; ++x)
            plane.rgba.insert(plane.rgba.end(), {static_cast<float>(x) / 4 + 2 * (2 - static_cast<float>(y)) / 3, 0, 0, 1});
    const ImageF clamped = height_slopes(plane, kWrapClamp, kWrapMirror), repeated = height_slopes(plane, kWrapRepeat, kWrapRepeat);
    for (const ImageF& slopes : {clamped, repeated}) {
        EXPECT_NEAR(slopes.at(1, 1)[0], 1, 1e-6);
        EXPECT_NEAR(slopes.at(1, 1)[1], 2, 1e-6);
    }
    EXPECT_NEAR(clamped.at(0, 1)[0], 0.5, 1e-6);
    EXPECT_NEAR(clamped.at(1, 0)[1], 1, 1e-6);
    EXPECT_NEAR(repeated.at(0, 1)[0], -1, 1e-6);
    EXPECT_NEAR(repeated.at(3, 1)[0], -1, 1e-6);
    EXPECT_NEAR(repeated.at(1, 2)[1], -1, 1e-6);
}

} // namespace
} // namespace lightbench
