// The sub-commands that need no device: plan, check, compare, make.
#include "program.h"

#include "image/files.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace lightbench::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Without any driver.
const Environment kNoDriver = {{"VK_ICD_FILENAMES", "/nowhere.json"}, {"VK_DRIVER_FILES", "/nowhere.json"}};

TEST_F(Cli, PlanOfOneDirectionalLightAndNoSpecularMaterial) {
    const Ran ran = run({"plan", scene(kPlain)}, kNoDriver);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("  - specular                     no material has ks > 0\n"));
    EXPECT_THAT(ran.out, HasSubstr("  - attenuation: linear          no light has a distance\n"));
    EXPECT_THAT(ran.out, HasSubstr("  diffuse                        the material has kd > 0\n"));
    EXPECT_THAT(ran.out, HasSubstr("  camera                         the scene has none"));
    EXPECT_THAT(ran.out, HasSubstr(" triangles, 1 light, 1280x720\n"));
    EXPECT_THAT(ran.err, IsEmpty());
}

TEST_F(Cli, PlanAsJson) {
    const Ran ran = run({"plan", scene(kPlain), "--json", "--shading", "flat", "--size", "100x50"}, kNoDriver);
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json plan = json::parse(ran.out);
    EXPECT_EQ(plan["shading"], "flat");
    EXPECT_EQ(plan["passes"][0]["name"], "shade-polygons");
    EXPECT_EQ(plan["width"], 100);
    EXPECT_GT(plan["triangles"], 10);
    for (const json& resource : plan["resources"]) EXPECT_GT(resource["bytes"], 0) << resource["name"];
    bool specular_skipped = false;
    for (const json& line : plan["skipped"]) specular_skipped |= line["effect"] == "specular" && line["reason"] == "no material has ks > 0";
    EXPECT_TRUE(specular_skipped);
}

TEST_F(Cli, PlanRefusesWhatOnlyARunHas) {
    EXPECT_EQ(run({"plan", scene(kPlain), "--stats", "-"}).code, 2);
    EXPECT_EQ(run({"plan", scene(kPlain), "--frames", "0:3"}).code, 2);
    EXPECT_EQ(run({"plan", in_folder("none.toml")}).code, 2);
}

TEST_F(Cli, CheckPrintsEveryProblemAndFails) {
    const std::string good = scene(kBall), bad = scene("[camera]\nfov = 200\n[[object]]\nshape = \"sphere\"\nradious = 2\n", "room.toml");
    const Ran ran = run({"check", good, bad}, kNoDriver);
    EXPECT_EQ(ran.code, 1);
    EXPECT_THAT(ran.out, HasSubstr("0 problems in " + good + "\n"));
    EXPECT_THAT(ran.out, HasSubstr("room.toml:2:"));
    EXPECT_THAT(ran.out, HasSubstr("room.toml:5:"));
    EXPECT_THAT(ran.out, HasSubstr(" problems in " + bad + "\n"));
    EXPECT_THAT(ran.err, IsEmpty());
    EXPECT_EQ(run({"check", good}).code, 0);
    EXPECT_EQ(run({"check", in_folder("none.toml")}).code, 1);
    EXPECT_EQ(run({"check"}).code, 2);
}

TEST_F(Cli, CheckFindsACameraWithoutDirection) {
    const Ran ran = run({"check", scene("[camera]\nposition = [1, 2, 3]\ntarget = [1, 2, 3]\n[[object]]\nshape = \"sphere\"\n")});
    EXPECT_EQ(ran.code, 1);
    EXPECT_THAT(ran.out, HasSubstr("camera"));
}

Image8 grey(std::uint8_t value, unsigned width = 16) {
    return {width, 16, std::vector<std::uint8_t>(std::size_t{width} * 16 * 4, value)};
}

TEST_F(Cli, CompareMeasuresAndGates) {
    write_png(in_folder("a.png"), grey(100));
    write_png(in_folder("b.png"), grey(151));
    const Ran same = run({"compare", in_folder("a.png"), in_folder("a.png"), "--json", "--max-flip", "0"}, kNoDriver);
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_EQ(json::parse(same.out)["rmse"], 0);
    EXPECT_TRUE(json::parse(same.out)["psnr"].is_null()); // infinite
    const Ran other = run({"compare", in_folder("a.png"), in_folder("b.png"), "--json", "--diff", in_folder("d.png")}, kNoDriver);
    EXPECT_EQ(other.code, 0);
    EXPECT_NEAR(json::parse(other.out)["rmse"].get<double>(), 51 / 255.0, 1e-12);
    EXPECT_NEAR(json::parse(other.out)["max"].get<double>(), 51 / 255.0, 1e-6);
    EXPECT_NEAR(json::parse(other.out)["psnr"].get<double>(), 20 * std::log10(5.0), 1e-9);
    const double flip = json::parse(other.out)["flip"];
    EXPECT_GT(flip, 0.01);
    EXPECT_EQ(std::get<Image8>(read_image(in_folder("d.png"))).width, 16u);
    const auto gate = [&](double x) {
        return run({"compare", in_folder("a.png"), in_folder("b.png"), "--max-flip", std::to_string(x)}).code;
    };
    EXPECT_EQ(gate(flip * 1.01), 0);
    EXPECT_EQ(gate(flip * 0.99), 1);
}

TEST_F(Cli, CompareInWords) {
    write_png(in_folder("a.png"), grey(100));
    const Ran ran = run({"compare", in_folder("a.png"), in_folder("a.png")});
    EXPECT_THAT(ran.out, HasSubstr("rmse   0 (display)\npsnr   inf dB\nmax    0\nflip   0.000000 mean"));
    EXPECT_THAT(ran.out, HasSubstr("differ 0 of 256 pixels"));
}

TEST_F(Cli, CompareRefusesWhatCannotBeCompared) {
    write_png(in_folder("a.png"), grey(1)), write_png(in_folder("wide.png"), grey(1, 17)),
        write_text(in_folder("broken.png"), "no picture");
    const Ran sizes = run({"compare", in_folder("a.png"), in_folder("wide.png")});
    EXPECT_EQ(sizes.code, 2);
    EXPECT_THAT(sizes.err, HasSubstr("wide.png"));
    EXPECT_EQ(run({"compare", in_folder("a.png"), in_folder("broken.png")}).code, 2);
    EXPECT_EQ(run({"compare", in_folder("a.png"), in_folder("none.png")}).code, 2);
    EXPECT_EQ(run({"compare", in_folder("a.png"), in_folder("a.png"), "--max-flip", "2"}).code, 2);
    EXPECT_EQ(run({"compare", in_folder("a.png"), in_folder("a.png"), "--diff", in_folder("d.jpg")}).code, 2);
    EXPECT_EQ(run({"compare", in_folder("a.png")}).code, 2);
}

TEST_F(Cli, MakeListsItsKinds) {
    const Ran ran = run({"make", "--list"}, kNoDriver);
    EXPECT_EQ(ran.code, 0);
    for (const char* kind :
         {"sphereflake", "primitives", "cornell-box", "corrugated", "highlight", "mach-band", "spheres", "mirrors", "room"})
        EXPECT_THAT("\n" + ran.out, HasSubstr("\n" + std::string(kind) + " ")) << kind;
    EXPECT_THAT(ran.out, HasSubstr("  depth "));
}

TEST_F(Cli, WhatIsMadeCanBeRead) {
    const std::string flake = in_folder("flake.toml");
    const Ran made = run({"make", "sphereflake", "--param", "depth=1", "-o", flake}, kNoDriver);
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_THAT(made.out, IsEmpty());
    EXPECT_EQ(run({"check", flake}).code, 0);
    EXPECT_EQ(run({"make", "highlight", "--param", "subdivide=2", "--param", "shininess=10", "-o", in_folder("h.toml")}).code, 0);
}

TEST_F(Cli, MakeRefusesWhatIsNoKind) {
    const auto message = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "make");
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.code, 2);
        EXPECT_THAT(ran.out, IsEmpty());
        return ran.err;
    };
    const std::string out = in_folder("x.toml");
    EXPECT_THAT(message({"spherflake", "-o", out}), HasSubstr("sphereflake"));
    EXPECT_THAT(message({"sphereflake", "--param", "dept=1", "-o", out}), HasSubstr("depth"));
    EXPECT_THAT(message({"sphereflake", "--param", "depth=x", "-o", out}), HasSubstr("depth"));
    EXPECT_THAT(message({"sphereflake", "--param", "depth", "-o", out}), HasSubstr("NAME=VALUE"));
    EXPECT_THAT(message({"sphereflake"}), HasSubstr("-o FILE is missing"));
    EXPECT_THAT(message({"-o", out}), HasSubstr("KIND is missing"));
    EXPECT_THAT(files(), IsEmpty());
}

} // namespace
} // namespace lightbench::cli
