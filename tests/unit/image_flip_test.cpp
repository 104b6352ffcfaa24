// FLIP: properties that the paper states, and the authors' own evaluator where it is installed.
#include "image/compare.h"
#include "image/files.h"
#include "unit/image_fixtures.h"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

using namespace lightbench;
using image_test::Ball;
using image_test::ball_picture;
using image_test::noise;
using image_test::TemporaryFolder;

namespace {

Image8 flat(unsigned width, unsigned height, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    Image8 image{.width = width, .height = height, .rgba = {}};
    for (unsigned i = 0; i < width * height; ++i) image.rgba.insert(image.rgba.end(), {r, g, b, 255});
    return image;
}

std::string python() {
    const char* chosen = std::getenv("LIGHTBENCH_PYTHON");
    return chosen ? chosen : "python3";
}

// The evaluator's map and mean: it reads the two PNG files and writes the floats raw, the mean first.
std::vector<float> evaluator(const TemporaryFolder& folder, const Image8& a, const Image8& b) {
    write_png(folder / "a.png", a);
    write_png(folder / "b.png", b);
    write_file(folder / "run.py", std::string_view(R"(
import sys, numpy, flip_evaluator
a, b, out = sys.argv[1:]
error, mean, _ = flip_evaluator.evaluate(a, b, "LDR", applyMagma=False)
with open(out, "wb") as f:
    f.write(numpy.float32(mean).tobytes())
    f.write(numpy.ascontiguousarray(error, dtype=numpy.float32).tobytes())
)"));
    std::string command =
        fmt::format("'{}' '{}' '{}' '{}' '{}'", python(), folder / "run.py", folder / "a.png", folder / "b.png", folder / "out");
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream in(folder / "out", std::ios::binary);
    std::vector<float> values(std::size_t{a.width} * a.height + 1);
    in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(float)));
    EXPECT_EQ(in.gcount(), static_cast<std::streamsize>(values.size() * sizeof(float)));
    return values;
}

} // namespace

TEST(Flip, EqualPicturesDoNotDiffer) {
    Image8 a = noise(64, 48, 1);
    for (float e : flip(a, a).error) ASSERT_EQ(e, 0.0f);
}

TEST(Flip, IsSymmetric) {
    Image8 a = noise(64, 48, 1), b = noise(64, 48, 2);
    EXPECT_EQ(flip(a, b).error, flip(b, a).error);
}

// 4.1.3: the scale is fixed by green against blue, which is the largest difference there is.
TEST(Flip, GreenAgainstBlueIsOne) {
    FlipMap map = flip(flat(40, 40, 0, 255, 0), flat(40, 40, 0, 0, 255));
    for (float e : map.error) ASSERT_NEAR(e, 1.0f, 1e-5f);
}

// Two flat greys have no features and are not changed by the filters: what is left is the difference of their L*, by hand.
TEST(Flip, FlatGreysByHand) {
    double largest = 0;
    { // CIELAB of pure green and pure blue with D65 (Lindbloom's table: 87.7347 -86.1827 83.1793, 32.2970 79.1875 -107.8602), Hunt-scaled
        double da = -86.1827 * 0.877347 - 79.1875 * 0.322970, db = 83.1793 * 0.877347 + 107.8602 * 0.322970;
        largest = std::pow(87.7347 - 32.2970 + std::hypot(da, db), 0.7);
    }
    double y = std::pow((188 / 255.0 + 0.055) / 1.055, 2.4), lightness = 116 * std::cbrt(y) - 16;
    double expected = 0.95 / (0.4 * largest) * std::pow(100 - lightness, 0.7);
    FlipMap map = flip(flat(40, 40, 188, 188, 188), flat(40, 40, 255, 255, 255));
    for (float e : map.error) ASSERT_NEAR(e, expected, 2e-4);
}

TEST(Flip, ASinglePixelIsSeenAtItsPlaceAndNowhereFar) {
    Image8 a = flat(101, 81, 128, 128, 128), b = a;
    for (int c = 0; c < 3; ++c) b.at(50, 40)[c] = 255;
    FlipMap map = flip(a, b);
    EXPECT_GT(map.error[40 * 101 + 50], 0.2f);
    EXPECT_LT(map.error[0], 1e-6f);
    EXPECT_NEAR(map.error[40 * 101 + 47], map.error[40 * 101 + 53], 1e-5f);
    EXPECT_NEAR(map.error[37 * 101 + 50], map.error[43 * 101 + 50], 1e-5f);
}

TEST(Flip, PercentilesAreOrdered) {
    FlipMap map{.width = 4, .height = 1, .error = {0.4f, 0.1f, 0.3f, 0.2f}};
    EXPECT_FLOAT_EQ(static_cast<float>(percentile(map, 0)), 0.1f);
    EXPECT_FLOAT_EQ(static_cast<float>(percentile(map, 1)), 0.4f);
    EXPECT_FLOAT_EQ(static_cast<float>(mean(map)), 0.25f);
}

TEST(Flip, DifferencePictureGetsLighter) {
    FlipMap map{.width = 256, .height = 1, .error = {}};
    for (int i = 0; i < 256; ++i) map.error.push_back(static_cast<float>(i) / 255.0f);
    Image8 picture = difference_picture(map);
    EXPECT_EQ(picture.at(0, 0)[0] + picture.at(0, 0)[1] + picture.at(0, 0)[2], 0);
    EXPECT_EQ(picture.at(255, 0)[0] + picture.at(255, 0)[1] + picture.at(255, 0)[2], 3 * 255);
    double before = -1;
    for (unsigned x = 0; x < 256; x += 5) {
        const auto* p = picture.at(x, 0);
        double light = 0.30 * p[0] + 0.59 * p[1] + 0.11 * p[2]; // the weights that the scheme is built on
        EXPECT_GT(light, before);
        before = light;
    }
}

TEST(Flip, Evaluator) {
    if (std::system(fmt::format("'{}' -c 'import flip_evaluator' 2>/dev/null", python()).c_str()) != 0)
        GTEST_SKIP() << "python3 has no flip_evaluator (pip install flip-evaluator; LIGHTBENCH_PYTHON chooses another python)";
    TemporaryFolder folder;
    std::vector<std::pair<Image8, Image8>> pairs = {
        {ball_picture(), ball_picture({.shift = 1})},
        {ball_picture(), ball_picture({.gain = 1.02f})},
        {ball_picture(), ball_picture({.second_light_flipped = true})},
        {ball_picture(), flat(320, 240, 255, 0, 255)},
        {noise(160, 120, 1), noise(160, 120, 2)},
        {noise(33, 200, 1), flat(33, 200, 20, 200, 90)},
        {flat(40, 40, 0, 255, 0), flat(40, 40, 0, 0, 255)},
    };
    for (std::size_t n = 0; n < pairs.size(); ++n) {
        FlipMap ours = flip(pairs[n].first, pairs[n].second);
        std::vector<float> theirs = evaluator(folder, pairs[n].first, pairs[n].second);
        EXPECT_NEAR(mean(ours), theirs[0], 1e-3) << "pair " << n;
        double worst = 0;
        for (std::size_t i = 0; i < ours.error.size(); ++i)
            worst = std::max(worst, std::abs(double{ours.error[i]} - double{theirs[i + 1]}));
        EXPECT_LE(worst, 1e-3) << "pair " << n;
        fmt::print("pair {}: mean {:.6f}, theirs {:.6f}, worst pixel {:.1e}\n", n, mean(ours), theirs[0], worst);
    }
}
