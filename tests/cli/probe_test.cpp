// `probe` as its users see it: terms that add up, trees whose every end has its reason, both methods, wrong pixels.
#include "program.h"

#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace lightbench::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

// Straight down on a plane: N.L, distances and terms are whole numbers, by hand.
const char* const kDown = R"([film]
width = 65
height = 49
[camera]
position = [0, 4, 0]
target = [0, 0, 0]
up = [0, 0, -1]
[environment]
background = [0.5, 0.25, 0.125]
ambient = [0.5, 0.5, 0.5]
[[light]]
position = [0, 2, 0]
intensity = 3
attenuation = "linear"
d0 = 1
[[light]]
position = [0, -2, 0]
intensity = 3
attenuation = "none"
[[material]]
name = "floor"
diffuse = [0.5, 0.25, 1]
specular = 0.125
shininess = 10
reflection = 0.5
[[object]]
shape = "polygon"
material = "floor"
points = [[-9, 0, 9], [9, 0, 9], [9, 0, -9], [-9, 0, -9]]
)";

class Probe : public Cli {
  protected:
    json probed(const std::string& text, const std::string& pixel, std::vector<std::string> options = {}) const {
        std::vector<std::string> arguments = {"probe", scene(text), pixel, "--json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return json::parse(ran.out, nullptr, false);
    }
};

json branch(const json& ray, const std::string& kind) {
    for (const json& stop : ray["stops"])
        if (stop["branch"] == kind) return stop["reason"];
    return nullptr;
}

TEST_F(Probe, TheEquationHasTheNumbersOfTheScene) {
    const json p = probed(kDown, "32,24", {"--method", "raytrace"});
    ASSERT_EQ(p["rays"].size(), 2u);
    const json &eye = p["rays"][0], &hit = eye["hit"], &light = hit["lights"][0], &below = hit["lights"][1];
    EXPECT_EQ(hit["material"], "floor");
    EXPECT_EQ(hit["object"], 0);
    EXPECT_NEAR(hit["distance"].get<double>(), 4, 1e-5);
    EXPECT_NEAR(light["distance"].get<double>(), 2, 1e-5);
    EXPECT_NEAR(light["nl"].get<double>(), 1, 1e-6);
    EXPECT_NEAR(light["attenuation"].get<double>(), 1.0 / 3, 1e-6);
    EXPECT_NEAR(light["diffuse"][1].get<double>(), 0.25, 1e-5);
    EXPECT_NEAR(light["specular"][1].get<double>(), 0.125, 1e-4);
    EXPECT_EQ(light["shadow"], json({1, 1, 1}));
    EXPECT_EQ(below["diffuse"], json({0, 0, 0}));
    EXPECT_NEAR(hit["ambient"][2].get<double>(), 0.5, 1e-6);
    EXPECT_TRUE(hit["agrees"].get<bool>());
    EXPECT_EQ(eye["children"], json({1}));
    EXPECT_EQ(branch(eye, "refracted"), "kt = 0");
    EXPECT_EQ(branch(eye, "straight"), "opacity = 1");
    const json& up = p["rays"][1];
    EXPECT_EQ(up["kind"], "reflected");
    EXPECT_EQ(up["level"], 2);
    EXPECT_EQ(branch(up, "reflected"), "it leaves the scene");
    EXPECT_NEAR(up["weight"][0].get<double>(), 0.5, 1e-6);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(p["radiance"][c].get<double>(), hit["sum"][c].get<double>() + 0.5 * up["radiance"][c].get<double>(), 1e-4);
}

TEST_F(Probe, EveryBranchSaysWhyItEnds) {
    EXPECT_EQ(branch(probed(kDown, "32,24", {"--method", "raytrace", "--depth", "1"})["rays"][0], "reflected"),
              "the depth of 1 is reached");
    EXPECT_THAT(branch(probed(kDown, "32,24", {"--method", "raytrace", "--cutoff", "0.6"})["rays"][0], "reflected").get<std::string>(),
                HasSubstr("cutoff of 0.6"));
    const std::string down = kDown;
    std::string plain = down;
    plain.replace(plain.find("reflection = 0.5"), 16, "reflection = 0.0");
    EXPECT_EQ(branch(probed(plain, "32,24", {"--method", "raytrace"})["rays"][0], "reflected"), "kr = 0");
    // A glass ball, seen from inside near its equator: total reflection.
    const std::string ball = R"([camera]
position = [0.9, 0, 0]
target = [0.9, 1, 0]
up = [0, 0, 1]
[film]
width = 33
height = 33
[[material]]
name = "glass"
diffuse = 0
transmission = 1
[[object]]
shape = "sphere"
material = "glass"
)";
    const json p = probed(ball, "16,16", {"--method", "raytrace", "--depth", "2"});
    ASSERT_EQ(p["rays"].size(), 2u) << p.dump(1);
    EXPECT_EQ(branch(p["rays"][0], "refracted"), "total internal reflection");
    EXPECT_EQ(p["rays"][0]["weight"], json({1, 1, 1}));
    EXPECT_EQ(branch(p["rays"][1], "refracted"), "the depth of 2 is reached");
}

TEST_F(Probe, TheRasteriserHasOneHitAndNoShadows) {
    const json drawn = probed(kBall, "32,24"), traced = probed(kBall, "32,24", {"--method", "raytrace"});
    EXPECT_EQ(drawn["method"], "raster");
    EXPECT_EQ(drawn["rays"].size(), 1u);
    EXPECT_EQ(drawn["rays"][0]["hit"]["object"], traced["rays"][0]["hit"]["object"]);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn["radiance"][c].get<double>(), drawn["rays"][0]["hit"]["sum"][c].get<double>(), 5e-3);
}

TEST_F(Probe, ThePixelIsThatOfTheImage) {
    const std::string path = scene(kDown);
    const Ran text = run({"probe", path, "10,40", "--method", "raytrace"});
    EXPECT_EQ(text.code, 0) << text.err;
    for (const char* part :
         {"pixel 10, 40", "eye ray, level 1", "N.L", "attenuation", "no refracted ray: kt = 0", "stops: it leaves the scene"})
        EXPECT_THAT(text.out, HasSubstr(part));
}

TEST_F(Probe, WrongPixelsAreTheUsersInput) {
    const std::string path = scene(kDown);
    for (const char* pixel : {"1", "a,b", "1,2,3", "-1,2", "65,0", "0,49"}) EXPECT_EQ(run({"probe", path, pixel}).code, 2) << pixel;
    EXPECT_EQ(run({"probe", path}).code, 2);
    EXPECT_EQ(run({"probe", path, "1,1", "--stats", "-"}).code, 2);
}

} // namespace
} // namespace lightbench::cli
