// Every knob turned once, small; what a report's folder holds afterwards; what is said of options that a knob turns.
#include "program.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace lightbench::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class CostKnobs : public Cli {
  protected:
    Ran cost(std::vector<std::string> more, const std::string& text = kBall) const {
        std::vector<std::string> arguments = {"cost", scene(text), "-o", in_folder("report"), "--rounds", "1", "--size", "24x18"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    json report() const { return json::parse(read_text(folder / "report" / "cost.json")); }
    std::vector<std::string> pictures() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder / "report" / "images")) names.push_back(entry.path().filename());
        return names;
    }
    // Each point has its picture and a finite error; returns the errors of the curve.
    std::vector<double> errors(const json& curve) const {
        std::vector<double> all;
        for (const json& point : curve["points"]) {
            EXPECT_TRUE(fs::exists(folder / "report" / point["image"])) << point["value"];
            EXPECT_GT(point["device_ms"], 0);
            all.push_back(point["errors"][curve["metric"]].get<double>());
        }
        return all;
    }
};

TEST_F(CostKnobs, OfRays) {
    const Ran ran = cost({"--knob", "contrast=1/1,0.1/3", "--knob", "filter=box,gaussian/2", "--knob", "cutoff=0.5,0.01", "--knob",
                          "depth=1,3", "--knob", "leaf=bvh/2,octree/4", "--knob", "octree-depth=2,4", "--strict"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json curves = report()["curves"];
    ASSERT_EQ(curves.size(), 6u);
    const auto contrast = errors(curves[0]);
    EXPECT_GT(contrast[0], contrast[1]);
    const auto filter = errors(curves[1]);
    EXPECT_GT(filter[1], filter[0]); // wider than a pixel, on purpose
    for (std::size_t i = 4; i < 6; ++i) EXPECT_EQ(errors(curves[i]), std::vector<double>(2, 0.0));
    EXPECT_THAT(curves[0]["notes"].dump(), HasSubstr("1 run is too few to tell"));
}

TEST_F(CostKnobs, OfRadiosity) {
    ASSERT_EQ(run({"make", "cornell-box", "-o", in_folder("box.toml")}).code, 0);
    const Ran ran = cost({"--knob", "hemicube=8,16,32", "--knob", "solver=full,progressive/0.1", "--knob",
                          "form-factors=corrected,hemicube/16", "--knob", "patch=600,400", "--patch", "400", "--until", "0.2", "--strict"},
                         read_text(in_folder("box.toml")));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("warning: --knob patch: it turns --patch; what was typed there has no effect"));
    EXPECT_THAT(ran.err, HasSubstr("warning: --knob solver: it turns --until"));
    const json curves = report()["curves"];
    ASSERT_EQ(curves.size(), 4u);
    EXPECT_GT(errors(curves[0])[0], errors(curves[0])[2]);
    const json slope = curves[0]["slopes"].back();
    EXPECT_EQ(slope["metric"], "sum");
    EXPECT_NEAR(slope["measured"], -2, 0.1);
    EXPECT_EQ(errors(curves[1]).size(), 2u);
    EXPECT_LT(errors(curves[2])[0], errors(curves[2])[1]);
    EXPECT_FALSE(curves[3]["points"][0]["errors"].contains("closure"));
}

// Stable against naive: no pictures, but limits as typed, and the worst errors of both.
TEST_F(CostKnobs, OfFunctions) {
    const Ran ran = cost({"--knob", "functions"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json curves = report()["curves"];
    EXPECT_EQ(curves.size(), 7u);
    for (const json& curve : curves) {
        EXPECT_EQ(curve["points"][0]["value"], "stable");
        EXPECT_EQ(curve["points"][0]["runs"], 1);
        EXPECT_EQ(curve["points"][1]["value"], "naive");
        EXPECT_LT(curve["points"][0]["errors"]["relative"].get<double>(), 1e-3);
    }
    EXPECT_TRUE(pictures().empty());
}

// Pictures of two values that are written alike, and none of an earlier report.
TEST_F(CostKnobs, PicturesAreThoseOfTheReport) {
    ASSERT_EQ(cost({"--knob", "grid-density=1e+1,1e-1"}).code, 0);
    EXPECT_THAT(pictures(), UnorderedElementsAre("grid-density-reference.png", "grid-density-1e-1.png", "grid-density-1e-1--2.png"));
    EXPECT_TRUE(fs::exists(folder / "report" / "grid-density-time.svg"));
    write_text(folder / "report" / "images" / "mine.png", "");
    ASSERT_EQ(cost({"--knob", "spp=4"}).code, 0);
    EXPECT_THAT(pictures(), UnorderedElementsAre("spp-reference.png", "spp-4.png", "mine.png"));
    EXPECT_FALSE(fs::exists(folder / "report" / "grid-density-time.svg"));
}

TEST_F(CostKnobs, FoldersInTheWayAreNamed) {
    fs::create_directories(folder / "report" / "cost.csv");
    write_text(folder / "report" / "images", "");
    const Ran ran = cost({"--knob", "spp=4"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr("images is a file; it must be a folder, or not exist yet"));
    EXPECT_THAT(ran.err, HasSubstr("cost.csv is a folder; a file goes there"));
}

// What a sweep measures is drawn by the user's shaders, or not at all.
TEST_F(CostKnobs, ShadersAreUsed) {
    const Ran missing = cost({"--knob", "spp=4", "--shader", in_folder("nowhere.glsl")});
    EXPECT_EQ(missing.code, 2);
    EXPECT_THAT(missing.err, HasSubstr("nowhere.glsl"));
    EXPECT_FALSE(fs::exists(folder / "report" / "cost.json"));
}

} // namespace
} // namespace lightbench::cli
