// devices and gallery.
#include "program.h"

#include "image/files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <regex>

namespace lightbench::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

TEST_F(Cli, DevicesAreListed) {
    const Ran text = run({"devices"}), as_json = run({"devices", "--json"});
    EXPECT_EQ(text.code, 0) << text.err;
    const json devices = json::parse(as_json.out);
    ASSERT_GE(devices.size(), 1u);
    EXPECT_THAT(text.out, HasSubstr(devices[0]["name"].get<std::string>()));
    EXPECT_THAT(text.out, HasSubstr("lacks"));
}

TEST_F(Cli, NoDriverIsSaid) {
    const Ran ran = run({"devices"}, {{"VK_ICD_FILENAMES", "/nowhere.json"}, {"VK_DRIVER_FILES", "/nowhere.json"}});
    EXPECT_EQ(ran.code, 3);
    EXPECT_THAT(ran.err, HasSubstr("lightbench: "));
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err; // one sentence
}

TEST_F(Cli, TheGalleryIsAPageWithItsPictures) {
    // Where LIGHTBENCH_ASSETS names no folder, the next place is looked at.
    const Ran ran = run({"gallery", "-o", in_folder("out"), "--size", "48x27", "--quiet"}, {{"LIGHTBENCH_ASSETS", in_folder("empty")}});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, in_folder("out/index.html") + "\n");
    const std::string page = read_text(folder / "out/index.html");
    const std::regex image("<img src=\"([^\"]+)\"");
    std::size_t pictures = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), image), end; at != end; ++at, ++pictures) {
        const Image8 picture =
            std::get<Image8>(read_image((folder / "out" / (*at)[1].str()).string())); // beside the page, no address elsewhere
        EXPECT_EQ(picture.width, 48u);
    }
    EXPECT_GE(pictures, 35u);
    EXPECT_EQ(page.find("http"), std::string::npos); // readable offline
    for (const char* part : {"Gouraud: lost", "corrugated", "crease", "Mach bands", "Metals", "Texture mapping", "Bump mapping",
                             "Environment mapping", "Exact transparency", "render glass.toml", "make panes", " ms", "no material"})
        EXPECT_THAT(page, HasSubstr(part));
}

TEST_F(Cli, TheGalleryRefusesWhatCannotBe) {
    EXPECT_EQ(run({"gallery", "-o", scene(kBall) + "/below"}).code, 2);
    EXPECT_EQ(run({"gallery", "-o", in_folder("out"), "--size", "big"}).code, 2);
}

TEST_F(Cli, EveryStoredSceneIsDrawnWithWhatItShows) {
    const std::pair<const char*, const char*> scenes[] = {
        {"grazing", "cook-torrance: beckmann"}, {"globe", "mapping: spherical"}, {"orange", "bump: noise"},
        {"teapot", "environment: mirrored"},    {"glass", "transparency"},       {"one-directional", "directional light"}};
    for (const auto& [name, effect] : scenes) {
        const std::string file = fmt::format("{}/assets/scenes/{}.toml", LIGHTBENCH_SOURCE, name);
        const Ran plan = run({"plan", file});
        EXPECT_THAT(plan.out, HasSubstr(fmt::format("\n  {} ", effect))) << name; // an effect that is not drawn has a dash
        const Ran ran = run({"render", file, "-o", in_folder("x.png"), "--size", "64x36", "--quiet"});
        EXPECT_EQ(ran.code, 0) << name << ": " << ran.err;
        EXPECT_EQ(std::get<Image8>(read_image(in_folder("x.png"))).width, 64u);
    }
}

} // namespace
} // namespace lightbench::cli
