// The tests of the golden test: a wrong picture, a wrong golden and a wrong tolerance must each be reported. No GPU.
#include "image/compare.h"
#include "images/golden.h"
#include "unit/image_fixtures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>

using namespace lightbench;
using image_test::Ball;
using image_test::ball_picture;
using image_test::TemporaryFolder;
using ::testing::HasSubstr;

namespace {

constexpr const char* kKey = "llvmpipe-1-256";

struct Mutation {
    const char* name;
    Ball ball;
};
const Mutation kMutations[] = {
    {"shifted by one pixel", {.shift = 1}}, {"2 % brighter", {.gain = 1.02f}}, {"one light flipped", {.second_light_flipped = true}}};

GoldenStore store_in(const TemporaryFolder& folder, const std::string& update = "") {
    return {.folder = folder.path() / "golden", .failures = folder.path() / "failures", .update = update};
}

Image8 shifted(const Image8& in) {
    Image8 out = in;
    for (unsigned y = 0; y < in.height; ++y) {
        for (unsigned x = in.width - 1; x > 0; --x) std::copy_n(in.at(x - 1, y), 4, out.at(x, y));
    }
    return out;
}

Image8 brighter(const Image8& in, float gain) {
    Image8 out = in;
    for (std::size_t i = 0; i < in.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        float linear = std::min(1.0f, gain * linear_from_srgb(static_cast<float>(in.rgba[i]) / 255.0f));
        out.rgba[i] = static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(linear)));
    }
    return out;
}

} // namespace

TEST(Golden, KeyIsFitForAFileName) {
    EXPECT_EQ(driver_key("llvmpipe", "1.3.230, Mesa 22.3.6 (LLVM 15.0.6)", 8), "llvmpipe-1.3.230-Mesa-22.3.6-LLVM-15.0.6-256");
    EXPECT_EQ(driver_key("../x", "/y", 4), "..-x-y-128");
}

TEST(Golden, MutationsFailBothGates) {
    Image8 golden = ball_picture();
    EXPECT_TRUE(judge_same_driver(golden, golden, {}).pass);
    EXPECT_TRUE(judge_other_driver(golden, golden, {}).pass);
    for (const Mutation& mutation : kMutations) {
        Image8 wrong = ball_picture(mutation.ball);
        EXPECT_FALSE(judge_same_driver(golden, wrong, {}).pass) << mutation.name;
        EXPECT_FALSE(judge_other_driver(golden, wrong, {}).pass) << mutation.name;
    }
}

// The tolerance is not so narrow that rounding elsewhere fails it: one step in a third of the pixels is no difference.
TEST(Golden, RoundingElsewherePasses) {
    Image8 golden = ball_picture(), other = golden;
    for (std::size_t i = 0; i < other.rgba.size(); i += 12) other.rgba[i] = static_cast<std::uint8_t>(other.rgba[i] ^ 1);
    EXPECT_TRUE(judge_same_driver(golden, other, {}).pass) << judge_same_driver(golden, other, {}).report;
}

TEST(Golden, OnlyAnUpdateOfThatNameWrites) {
    TemporaryFolder folder;
    Verdict missing = check_golden(store_in(folder), "ball", kKey, ball_picture());
    EXPECT_FALSE(missing.pass);
    EXPECT_THAT(missing.report, HasSubstr("--update-golden ball"));
    EXPECT_FALSE(check_golden(store_in(folder, "another"), "ball", kKey, ball_picture()).pass);
    EXPECT_FALSE(std::filesystem::exists(folder / "golden/ball"));

    EXPECT_THAT(check_golden(store_in(folder, "ball"), "ball", kKey, ball_picture()).report, HasSubstr("none before"));
    EXPECT_TRUE(check_golden(store_in(folder), "ball", kKey, ball_picture()).pass);
    Verdict again = check_golden(store_in(folder, "ball"), "ball", kKey, ball_picture({.shift = 1}));
    EXPECT_TRUE(again.pass);
    EXPECT_THAT(again.report, ::testing::ContainsRegex("against the one before: [0-9.]+ % of the pixels differ"));
}

TEST(Golden, AWrongGoldenIsReportedWithItsFiguresAndPictures) {
    TemporaryFolder folder;
    for (const Mutation& mutation : kMutations) {
        check_golden(store_in(folder, "ball"), "ball", kKey, ball_picture(mutation.ball)); // the golden is wrong
        Verdict verdict = check_golden(store_in(folder), "ball", kKey, ball_picture());
        EXPECT_FALSE(verdict.pass) << mutation.name;
        EXPECT_THAT(verdict.report, HasSubstr("of the pixels differ by more than 1/255"));
        EXPECT_TRUE(std::filesystem::exists(folder / "failures/ball/difference.png"));
        Verdict other = check_golden(store_in(folder), "ball", "another-driver-128", ball_picture());
        EXPECT_FALSE(other.pass) << mutation.name;
        EXPECT_THAT(other.report, HasSubstr("another driver's golden: FLIP"));
    }
}

TEST(Golden, AnotherDriverIsHeldAgainstThePinnedOne) {
    TemporaryFolder folder;
    check_golden(store_in(folder, "ball"), "ball", kKey, ball_picture());
    EXPECT_TRUE(check_golden(store_in(folder), "ball", "another-driver-128", ball_picture()).pass);
    std::filesystem::remove(folder / fmt::format("golden/ball/{}.png", kKey));
    EXPECT_THAT(check_golden(store_in(folder), "ball", "another-driver-128", ball_picture()).report, HasSubstr("cannot be opened"));
}

TEST(Golden, WhatCannotBeReadFails) {
    TemporaryFolder folder;
    check_golden(store_in(folder, "ball"), "ball", kKey, ball_picture());
    std::string tolerance = folder / "golden/ball/tolerance.toml", picture = folder / fmt::format("golden/ball/{}.png", kKey);
    EXPECT_FALSE(check_golden(store_in(folder), "ball", kKey, ball_picture({.width = 321})).pass);
    for (const char* text : {"", "pinned = 3", "pinned = \"a\"\nmax_chanel = 1\nfraction = 0\nflip_mean = 0\nflip_p99 = 0\n",
                             "pinned = \"a\"\nmax_channel = -1\nfraction = 0\nflip_mean = 0\nflip_p99 = 0\n", "][", "\xff"}) {
        write_file(tolerance, std::string_view(text));
        EXPECT_FALSE(check_golden(store_in(folder), "ball", kKey, ball_picture()).pass) << text;
    }
    std::filesystem::remove(tolerance);
    EXPECT_FALSE(check_golden(store_in(folder), "ball", kKey, ball_picture()).pass);
    check_golden(store_in(folder, "ball"), "ball", kKey, ball_picture());
    write_file(picture, std::string_view("not a picture"));
    EXPECT_THAT(check_golden(store_in(folder), "ball", kKey, ball_picture()).report, HasSubstr("not a PNG"));
}

// Every golden of this checkout, with the tolerance stored beside it: a picture too flat or a tolerance too wide to notice is a fault.
TEST(Golden, EveryStoredGoldenNoticesAShiftAndAGain) {
    std::filesystem::path stored = golden_store().folder;
    if (!std::filesystem::exists(stored)) GTEST_SKIP() << "no golden is stored yet";
    TemporaryFolder failures;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(stored)) {
        if (entry.path().extension() != ".png") continue;
        Image8 golden = std::get<Image8>(read_image(entry.path().string()));
        std::string name = entry.path().parent_path().filename().string(), key = entry.path().stem().string();
        GoldenStore store{.folder = stored, .failures = failures.path(), .update = {}};
        EXPECT_TRUE(check_golden(store, name, key, golden).pass) << entry.path();
        EXPECT_FALSE(check_golden(store, name, key, shifted(golden)).pass) << entry.path();
        EXPECT_FALSE(check_golden(store, name, key, brighter(golden, 1.02f)).pass) << entry.path();
    }
}
