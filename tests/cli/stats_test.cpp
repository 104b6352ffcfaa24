// --stats: every field of the contract is there, null where it does not apply.
#include "program.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace lightbench::cli {
namespace {

using nlohmann::json;
using ::testing::Contains;

const char* const kFields[] = {"/scene",
                               "/method",
                               "/width",
                               "/height",
                               "/device/name",
                               "/device/driver",
                               "/device/version",
                               "/plan/effects",
                               "/plan/passes",
                               "/plan/skipped",
                               "/time/load",
                               "/time/accel_build",
                               "/time/pipelines",
                               "/time/device",
                               "/time/wall",
                               "/time/passes",
                               "/counting",
                               "/rays",
                               "/tests",
                               "/radiosity",
                               "/memory/device_peak",
                               "/memory/host_peak",
                               "/image/non_finite"};

TEST_F(Cli, StatsHoldEveryField) {
    const Ran ran = run({"render", scene(kBall), "-o", in_folder("x.png"), "--shading", "gouraud", "--stats", "-"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json stats = json::parse(ran.out);
    for (const char* field : kFields) EXPECT_TRUE(stats.contains(json::json_pointer(field))) << field;
    EXPECT_EQ(stats["scene"], in_folder("scene.toml"));
    EXPECT_EQ(stats["method"], "raster");
    EXPECT_EQ(stats["width"], 64);
    EXPECT_EQ(stats["height"], 48);
    EXPECT_FALSE(stats["counting"]);
    EXPECT_TRUE(stats["rays"].is_null() && stats["tests"].is_null() && stats["radiosity"].is_null() &&
                stats["time"]["accel_build"].is_null());
    EXPECT_EQ(stats["image"]["non_finite"], 0);
    EXPECT_THAT(stats["shaders"].get<std::vector<std::string>>(), Contains("raster/surface.frag"));
    EXPECT_GT(stats["memory"]["host_peak"], 1 << 20);
    EXPECT_GT(stats["memory"]["device_peak"], 64 * 48 * 16);
}

TEST_F(Cli, StatsTellThePlanAndTheTimes) {
    const Ran ran = run({"render", scene(kBall), "-o", in_folder("x.png"), "--shading", "gouraud", "--stats", "-"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json stats = json::parse(ran.out);
    EXPECT_EQ(stats["plan"]["passes"], json({"shade-vertices", "raster", "display"}));
    EXPECT_THAT(stats["plan"]["effects"].get<std::vector<std::string>>(), Contains("specular"));
    EXPECT_THAT(stats["plan"]["skipped"].get<std::vector<json>>(),
                Contains(json({{"effect", "texture"}, {"reason", "no material has a picture"}})));
    double sum = 0;
    for (const json& pass : stats["time"]["passes"]) sum += pass["device"].get<double>();
    EXPECT_GT(stats["time"]["device"], 0);
    EXPECT_LE(sum, stats["time"]["device"].get<double>() * 1.0001);
    EXPECT_GE(stats["time"]["wall"], stats["time"]["device"]);
}

TEST_F(Cli, CountedRunsOfTheRasteriserHaveNoRays) {
    const Ran ran = run({"render", scene(kBall), "-o", in_folder("x.png"), "--count", "--stats", in_folder("s.json")});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, "");
    const json stats = json::parse(read_text(in_folder("s.json")));
    EXPECT_TRUE(stats["counting"]);
    EXPECT_EQ(stats["rays"]["eye"], 0);
    for (const char* name : {"eye", "eye_hit", "shadow", "reflected", "refracted"}) EXPECT_TRUE(stats["rays"].contains(name)) << name;
    for (const char* name : {"sphere", "polygon", "triangle", "box", "cone", "cylinder", "torus", "node", "voxel"})
        EXPECT_TRUE(stats["tests"].contains(name)) << name;
}

TEST_F(Cli, StatsOfFramesNeedFilesOfTheirOwn) {
    const std::string ball = scene(kBall);
    const Ran ran = run({"render", ball, "-o", in_folder("x%d.png"), "--frames", "0:1", "--stats", in_folder("s.json")});
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, ::testing::HasSubstr("--stats"));
    ASSERT_EQ(run({"render", ball, "-o", in_folder("x%d.png"), "--frames", "0:1", "--stats", in_folder("s%d.json")}).code, 0);
    EXPECT_EQ(json::parse(read_text(in_folder("s1.json")))["frame"], 1);
}

} // namespace
} // namespace lightbench::cli
