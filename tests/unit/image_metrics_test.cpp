// Display and metrics against values worked out by hand.
#include "image/compare.h"
#include "image/display.h"
#include "unit/image_fixtures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

using namespace lightbench;
using image_test::noise;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

ImageF pixels(unsigned width, unsigned height, std::initializer_list<float> rgba) {
    return {.width = width, .height = height, .rgba = rgba};
}

} // namespace

// The oracle is IEC 61966-2-1 in double; 188 for a half is the well-known value.
TEST(Display, IsTheStandardCurve) {
    EXPECT_EQ(std::lround(255 * srgb_from_linear(0.5f)), 188);
    for (int i = 0; i <= 100000; ++i) {
        double linear = i / 100000.0;
        double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
        ASSERT_NEAR(srgb_from_linear(static_cast<float>(linear)), encoded, 2e-7) << linear;
    }
    for (int v = 0; v < 256; ++v) {
        float linear = linear_from_srgb(static_cast<float>(v) / 255.0f);
        EXPECT_EQ(display(pixels(1, 1, {linear, linear, linear, 1})).rgba[0], v);
    }
}

TEST(Display, ExposesClampsAndSparesAlpha) {
    ImageF image = pixels(3, 1, {0.25f, -1, 7, 0.5f, kNan, kInf, -kInf, kNan, 0.5f, 0, 0, 2});
    EXPECT_EQ(display(image, 1).rgba, (std::vector<std::uint8_t>{188, 0, 255, 128, 0, 255, 0, 0, 255, 0, 0, 255}));
    EXPECT_EQ(count_non_finite(image), 1u);
}

TEST(Metrics, LinearByHand) {
    ImageF a = pixels(2, 1, {0, 0, 0, 1, 1, 1, 1, 1}), b = pixels(2, 1, {0.3f, 0, 0, 0, 1, 1, 0.6f, 1});
    Metrics m = metrics(a, b);
    EXPECT_NEAR(m.rmse, std::sqrt((0.09 + 0.16) / 6), 1e-7);
    EXPECT_NEAR(m.psnr, -10 * std::log10(0.25 / 6), 1e-5);
    EXPECT_NEAR(m.max, 0.4, 1e-7);
    EXPECT_EQ(m.differing, 2u);
}

TEST(Metrics, EightBitsAreDisplayValues) {
    Image8 a{.width = 1, .height = 1, .rgba = {0, 51, 255, 255}}, b{.width = 1, .height = 1, .rgba = {51, 51, 255, 0}};
    Metrics m = metrics(a, b);
    EXPECT_NEAR(m.max, 0.2, 1e-12);
    EXPECT_NEAR(m.rmse, 0.2 / std::sqrt(3.0), 1e-12);
    EXPECT_EQ(m.differing, 1u);
}

TEST(Metrics, EqualPicturesAreInfinitelyGood) {
    Image8 a = noise(20, 20, 3);
    Metrics m = metrics(a, a);
    EXPECT_EQ(m.rmse, 0);
    EXPECT_EQ(m.max, 0);
    EXPECT_TRUE(std::isinf(m.psnr) && m.psnr > 0);
}

TEST(Metrics, SizesMustAgree) {
    EXPECT_THROW(metrics(noise(2, 3, 1), noise(3, 2, 1)), std::invalid_argument);
    EXPECT_THROW(flip(noise(2, 3, 1), noise(3, 2, 1)), std::invalid_argument);
}

TEST(Metrics, NonFinitePixelsAreCountedNotHidden) {
    ImageF a = pixels(3, 1, {0, 0, 0, 1, 0, 0, 0, 1, 0.5f, 0.5f, 0.5f, 1}), b = a;
    b.rgba[0] = kNan, b.rgba[5] = kInf;
    Comparison c = compare(a, b);
    EXPECT_EQ(c.space, "linear");
    EXPECT_EQ(c.metrics.non_finite_reference, 0u);
    EXPECT_EQ(c.metrics.non_finite_test, 2u);
    EXPECT_TRUE(std::isinf(c.metrics.rmse) && std::isinf(c.metrics.max));
    EXPECT_TRUE(std::isinf(c.metrics.psnr) && c.metrics.psnr < 0);
    EXPECT_EQ(c.metrics.differing, 2u);
    EXPECT_EQ(c.flip_map.error[0], 1.0f); // NaN displays as the black that the reference has: still an error
    EXPECT_GT(c.flip_mean, 0.6);
}

TEST(Metrics, PicturesWithoutAFinitePixelAreNotEqual) {
    ImageF a = pixels(1, 1, {kNan, kNan, kNan, 1});
    for (const Comparison& c : {compare(a, a), compare(a, display(a)), compare(display(a), a)}) {
        EXPECT_EQ(c.metrics.differing, 1u);
        EXPECT_TRUE(std::isinf(c.metrics.rmse) && std::isinf(c.metrics.psnr) && c.metrics.psnr < 0);
    }
}

TEST(Compare, LinearAgainstDisplayedIsComparedOnTheScreen) {
    ImageF radiance = image_test::ball_radiance({});
    Comparison c = compare(radiance, display(radiance));
    EXPECT_EQ(c.space, "display");
    EXPECT_EQ(c.metrics.max, 0);
    EXPECT_EQ(c.flip_mean, 0);
}
