// `render` as its users see it: pictures, layers, frames, samples, crops, devices, messages.
#include "program.h"

#include "image/files.h"
#include "image/metrics.h"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>

namespace lightbench::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Render : public Cli {
  protected:
    // Renders the ball with these options into NAME; expects success.
    std::string picture(const std::string& name, std::vector<std::string> options = {}) const {
        const std::string path = in_folder(name);
        std::vector<std::string> arguments = {"render", scene(kBall), "-o", path};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_THAT(ran.out, IsEmpty());
        return path;
    }
    Image8 pixels(const std::string& name, std::vector<std::string> options = {}) const {
        return std::get<Image8>(read_image(picture(name, std::move(options))));
    }
    ImageF radiance(const std::string& name, std::vector<std::string> options = {}) const {
        return std::get<ImageF>(read_image(picture(name, std::move(options))));
    }
};

TEST_F(Render, APngShowsTheBallBeforeTheBackground) {
    const Image8 image = pixels("x.png");
    ASSERT_EQ(image.width, 64u);
    ASSERT_EQ(image.height, 48u);
    const std::uint8_t* centre = image.at(32, 24);
    EXPECT_GT(centre[0], 100); // red, lit
    EXPECT_LT(centre[1], centre[0] / 2);
    const std::uint8_t* corner = image.at(0, 0);
    EXPECT_EQ(corner[0], 63);  // the sRGB code of 0.05, by the standard's table
    EXPECT_EQ(corner[1], 89);  // of 0.1
    EXPECT_EQ(corner[2], 124); // of 0.2
}

TEST_F(Render, AnExrHoldsLinearRadianceAndIgnoresExposureAloud) {
    const ImageF image = radiance("x.exr");
    EXPECT_FLOAT_EQ(image.at(0, 0)[0], 0.05f);
    EXPECT_FLOAT_EQ(image.at(0, 0)[2], 0.2f);
    const Ran ran = run({"render", scene(kBall), "-o", in_folder("y.exr"), "--exposure", "1"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_THAT(ran.err, HasSubstr("note: exposure: "));
    EXPECT_EQ(read_text(in_folder("x.exr")), read_text(in_folder("y.exr")));
}

TEST_F(Render, ExposureDoublesTheLightPerStop) {
    const Image8 image = pixels("x.png", {"--exposure", "1"});
    EXPECT_EQ(image.at(0, 0)[0], 89);  // 2 * 0.05 shows as 0.1
    EXPECT_EQ(image.at(0, 0)[1], 124); // 2 * 0.1 as 0.2
}

TEST_F(Render, TheTermsAddUpToTheImage) {
    const std::string path = picture("x.exr", {"--terms"});
    const std::vector<ExrLayer> layers = read_exr(path);
    std::vector<std::string> names;
    for (const ExrLayer& layer : layers) names.push_back(layer.name);
    EXPECT_THAT(names, ::testing::UnorderedElementsAre("", "ambient", "diffuse", "specular", "background", "attenuation", "normal", "depth",
                                                       "object"));
    const ImageF& image = layers.front().pixels;
    double worst = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        double sum = 0;
        for (const ExrLayer& layer : layers)
            for (const char* term : {"ambient", "diffuse", "specular", "background"})
                if (layer.name == term) sum += double(layer.pixels.rgba[i]);
        worst = std::max(worst, std::abs(sum - double(image.rgba[i])));
    }
    EXPECT_LE(worst, 4e-7); // terms below 2, each rounded a few times by 6e-8
}

TEST_F(Render, ACropIsThatPartOfTheImage) {
    const Image8 whole = pixels("whole.png"), crop = pixels("crop.png", {"--crop", "20,10,30,25"});
    ASSERT_EQ(crop.width, 30u);
    ASSERT_EQ(crop.height, 25u);
    for (unsigned y = 0; y < 25; ++y)
        for (unsigned x = 0; x < 30; ++x) EXPECT_EQ(std::memcmp(crop.at(x, y), whole.at(x + 20, y + 10), 4), 0) << x << ' ' << y;
}

TEST_F(Render, FramesAreTheSameBytesAloneAndInSequence) {
    const std::string scene_file = scene(kBall);
    const Ran ran = run({"render", scene_file, "-o", in_folder("f%03d.png"), "--frames", "-1:1"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(files(), ElementsAre("f-01.png", "f000.png", "f001.png", "scene.toml"));
    picture("alone.png", {"--frame", "1"});
    picture("still.png");
    EXPECT_EQ(read_text(in_folder("alone.png")), read_text(in_folder("f001.png")));
    EXPECT_EQ(read_text(in_folder("still.png")), read_text(in_folder("f000.png")));
    EXPECT_NE(read_text(in_folder("f001.png")), read_text(in_folder("f-01.png"))); // the lamp does not turn with the camera
}

TEST_F(Render, TheShadingsDiffer) {
    const Image8 flat = pixels("flat.png", {"--shading", "flat"}), gouraud = pixels("gouraud.png", {"--shading", "gouraud"});
    const Image8 phong = pixels("phong.png", {"--shading", "phong"}), byte_for_byte = pixels("default.png");
    EXPECT_GT(metrics(phong, flat).rmse, metrics(phong, gouraud).rmse);
    EXPECT_GT(metrics(phong, gouraud).rmse, 0);
    EXPECT_EQ(phong.rgba, byte_for_byte.rgba); // phong is the default
}

TEST_F(Render, SubdividingFacetsBringsFlatNearerToPhong) {
    // Each beside Phong on the same facets, so that the outline, which refining moves too, is not counted.
    const Image8 coarse_phong = pixels("coarse_phong.png"), coarse = pixels("coarse.png", {"--shading", "flat"});
    const Image8 fine_phong = pixels("fine_phong.png", {"--subdivide", "2"});
    const Image8 fine = pixels("fine.png", {"--shading", "flat", "--subdivide", "2"});
    EXPECT_LT(metrics(fine_phong, fine).rmse, 0.6 * metrics(coarse_phong, coarse).rmse);
}

// The mean over an edge approaches the same value whatever the pattern; one sample a pixel does not.
TEST_F(Render, SamplesSmoothTheOutline) {
    const ImageF truth = radiance("truth.exr", {"--spp", "256"}), one = radiance("one.exr");
    const ImageF four = radiance("four.exr", {"--spp", "4"}), nine = radiance("nine.exr", {"--spp", "9"});
    const ImageF jittered = radiance("jittered.exr", {"--spp", "9", "--sampling", "jittered"});
    const double coarse = metrics(truth, one).rmse;
    EXPECT_LT(metrics(truth, four).rmse, 0.6 * coarse);
    EXPECT_LT(metrics(truth, nine).rmse, 0.5 * coarse);
    EXPECT_LT(metrics(truth, jittered).rmse, 0.6 * coarse);
}

TEST_F(Render, JitterFollowsTheSeed) {
    const auto jittered = [&](const char* name, const char* seed) {
        return pixels(name, {"--spp", "4", "--sampling", "jittered", "--seed", seed}).rgba;
    };
    const auto first = jittered("a.png", "1");
    EXPECT_EQ(first, jittered("b.png", "1"));
    EXPECT_NE(first, jittered("c.png", "2"));
}

TEST_F(Render, MessagesGoToStandardErrorAndQuietSilencesThem) {
    const std::string plain = scene(kPlain);
    const Ran loud = run({"render", plain, "-o", in_folder("x.png"), "--size", "16x16"});
    EXPECT_THAT(loud.err, HasSubstr("note: camera: the scene has none"));
    EXPECT_THAT(loud.err, HasSubstr("x.png: 16x16, "));
    const Ran quiet = run({"render", plain, "-o", in_folder("x.png"), "--size", "16x16", "--quiet"});
    EXPECT_EQ(quiet.code, 0);
    EXPECT_EQ(quiet.err + quiet.out, "");
    const Ran watched = run({"render", plain, "-o", in_folder("x.png"), "--size", "16x16", "--quiet", "--progress", "always"});
    EXPECT_THAT(watched.err, StartsWith("... reading "));
}

TEST_F(Render, BadScenesAreRefusedWithTheirLines) {
    const std::string bad = scene("[[object]]\nshape = \"sphere\"\nradious = 2\n\n[[light]]\ntype = \"candle\"\n", "room.toml");
    const Ran ran = run({"render", bad, "-o", in_folder("x.png")});
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr("room.toml:3:"));
    EXPECT_THAT(ran.err, HasSubstr("room.toml:6:"));
    EXPECT_THAT(ran.out, IsEmpty());
    EXPECT_THAT(files(), ElementsAre("room.toml"));
    EXPECT_EQ(run({"render", in_folder("none.toml"), "-o", in_folder("x.png")}).code, 2);
}

TEST_F(Render, DevicesAreChosenByNameOrIndex) {
    const std::string ball = scene(kBall), out = in_folder("x.png");
    const Ran unknown = run({"render", ball, "-o", out, "--device", "voodoo"});
    EXPECT_EQ(unknown.code, 3);
    EXPECT_THAT(unknown.err, HasSubstr("voodoo"));
    EXPECT_THAT(unknown.out, IsEmpty());
    EXPECT_EQ(run({"render", ball, "-o", out}, {{"LIGHTBENCH_DEVICE", "voodoo"}}).code, 3);
    EXPECT_THAT(files(), ElementsAre("scene.toml"));
    EXPECT_EQ(run({"render", ball, "-o", out, "--device", "0"}, {{"LIGHTBENCH_DEVICE", "voodoo"}}).code, 0); // the option wins
    EXPECT_EQ(run({"render", ball, "-o", out}, {{"VK_ICD_FILENAMES", "/nowhere.json"}, {"VK_DRIVER_FILES", "/nowhere.json"}}).code, 3);
}

// Files larger than 512 bytes cannot be written here: the disk is full, in effect.
TEST_F(Render, AFailedWriteKeepsTheOldFile) {
    if (run({"devices"}).out.find("SwiftShader") != std::string::npos) GTEST_SKIP() << "SwiftShader keeps device memory in a file";
    write_text(in_folder("x.png"), "what was there before");
    const Ran ran = run({"render", scene(kBall), "-o", in_folder("x.png")}, {}, "trap '' XFSZ; ulimit -f 1");
    EXPECT_EQ(ran.code, 3);
    EXPECT_THAT(ran.err, HasSubstr("x.png"));
    EXPECT_EQ(read_text(in_folder("x.png")), "what was there before");
    EXPECT_THAT(files(), ElementsAre("scene.toml", "x.png")); // no half-written one beside it
}

TEST_F(Render, ANameWithAPercentSignIsANameWithoutFrames) {
    picture("100%d.png");
    EXPECT_THAT(files(), ElementsAre("100%d.png", "scene.toml"));
}

} // namespace
} // namespace lightbench::cli
