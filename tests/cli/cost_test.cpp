// Accuracy against time as its users type it: small sweeps and whole reports.
#include "program.h"

#include "image/files.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace lightbench::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class Cost : public Cli {
  protected:
    Ran cost(std::vector<std::string> more, const std::string& text = kBall) const {
        std::vector<std::string> arguments = {"cost", scene(text), "-o", in_folder("report"), "--rounds", "2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    json report() const { return json::parse(read_text(folder / "report" / "cost.json")); }
    // The only curve of a report that was made well.
    json curve(const std::vector<std::string>& more, const std::string& text = kBall) const {
        const Ran ran = cost(more, text);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return report()["curves"][0];
    }
    std::vector<double> errors(const json& curve, const std::string& metric = "rmse") const {
        std::vector<double> all;
        for (const json& point : curve["points"]) all.push_back(point["errors"][metric]);
        return all;
    }
};

TEST_F(Cost, WritesAWholeReport) {
    const Ran ran = cost({"--knob", "spp=uniform/1,uniform/4,jittered/16", "--knob", "shading=flat,phong", "--size", "48x36"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("spp: samples a pixel"));
    EXPECT_THAT(ran.out, HasSubstr("uncertainty of the reference"));
    const std::string csv = read_text(folder / "report" / "cost.csv");
    EXPECT_TRUE(csv.starts_with("knob,value,metric,error,device_ms,q1_ms,q3_ms,runs,pareto,image\n"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 5 * 4);
    const json told = report();
    EXPECT_EQ(told["width"], 48);
    EXPECT_FALSE(told["device"]["name"].get<std::string>().empty());
    for (const json& curve : told["curves"]) {
        EXPECT_TRUE(fs::exists(folder / "report" / curve["reference"]["image"]));
        EXPECT_GT(curve["reference"]["error"]["rmse"], 0);
        EXPECT_GT(curve["points"][0]["errors"]["rmse"], curve["reference"]["error"]["rmse"]);
        for (const json& point : curve["points"]) {
            const Image8 picture = std::get<Image8>(read_image(folder / "report" / point["image"]));
            EXPECT_EQ(picture.width, 48u);
            EXPECT_EQ(point["runs"], 2);
            EXPECT_FALSE(point["settled"]);
            EXPECT_GT(point["device_ms"], 0);
            EXPECT_LE(point["q1_ms"], point["device_ms"]);
            EXPECT_GE(point["q3_ms"], point["device_ms"]);
        }
        EXPECT_THAT(curve["notes"].dump(), HasSubstr("2 runs are too few to tell"));
    }
}

// The command beside a point makes its picture, to a step of 255: a report's pictures are displayed by the host, render's by the device.
TEST_F(Cost, CommandsRepeatPictures) {
    const json point = curve({"--knob", "spp=jittered/9", "--size", "48x36"})["points"][0];
    std::string command = point["command"];
    ASSERT_TRUE(command.starts_with("lightbench render ")) << command;
    EXPECT_THAT(command, HasSubstr("--sampling jittered"));
    command.replace(0, std::string("lightbench").size(), LIGHTBENCH_PROGRAM);
    ASSERT_EQ(std::system(("cd '" + folder.string() + "' && " + command + " 2>/dev/null").c_str()), 0) << command;
    const std::string picture = in_folder(fs::path(point["image"].get<std::string>()).filename());
    const Image8 again = std::get<Image8>(read_image(picture)), stored = std::get<Image8>(read_image(folder / "report" / point["image"]));
    ASSERT_EQ(again.rgba.size(), stored.rgba.size());
    for (std::size_t i = 0; i < again.rgba.size(); ++i) ASSERT_LE(std::abs(int(again.rgba[i]) - int(stored.rgba[i])), 1) << i;
}

TEST_F(Cost, ErrorsFallWithSamplesAndRefinement) {
    const json samples = curve({"--knob", "spp=jittered/1,jittered/4,jittered/16,jittered/64", "--strict", "--size", "64x48"});
    EXPECT_TRUE(std::ranges::is_sorted(errors(samples), std::greater())) << samples;
    EXPECT_NEAR(samples["slopes"][0]["measured"], -0.75, 0.2);
    EXPECT_EQ(samples["slopes"][0]["theory"], -0.75);
    ASSERT_EQ(run({"make", "highlight", "-o", in_folder("lost.toml")}).code, 0);
    const json refined = curve({"--knob", "shading=gouraud/1,gouraud/2,gouraud/3,gouraud/4,gouraud/5", "--strict", "--size", "96x54"},
                               read_text(in_folder("lost.toml")));
    EXPECT_TRUE(std::ranges::is_sorted(errors(refined), std::greater())) << refined;
}

TEST_F(Cost, StructuresGiveEqualPictures) {
    const json structures = curve({"--knob", "accel=none,bvh,sphere-bvh,grid,octree", "--strict", "--size", "48x36"});
    EXPECT_TRUE(structures["time_only"]);
    EXPECT_EQ(errors(structures, "maximum"), std::vector<double>(5, 0.0));
    const json cells = curve({"--knob", "grid-density=1,8", "--strict", "--size", "48x36"});
    EXPECT_EQ(errors(cells), std::vector<double>(2, 0.0));
}

TEST_F(Cost, RadiosityIsSolvedAnewInEveryRun) {
    ASSERT_EQ(run({"make", "cornell-box", "-o", in_folder("box.toml")}).code, 0);
    const json shots = curve({"--knob", "shots=4/no-ambient,64/no-ambient", "--patch", "200", "--size", "32x32", "--strict"},
                             read_text(in_folder("box.toml")));
    const auto found = errors(shots);
    EXPECT_GT(found[0], 2 * found[1]);
    for (const json& point : shots["points"]) EXPECT_EQ(point["note"], ""); // all runs gave one picture
    EXPECT_GT(shots["points"][1]["device_ms"].get<double>(), 1.5 * shots["points"][0]["device_ms"].get<double>());
}

TEST_F(Cost, ListNamesKnobsAndReferences) {
    const Ran ran = run({"cost", "--list"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    for (const char* name : {"shading", "model", "attenuation", "spp", "filter", "contrast", "depth", "cutoff", "accel", "hemicube",
                             "patch", "shots", "solver", "form-factors", "precision", "grid-density", "octree-depth", "leaf", "functions"})
        EXPECT_THAT("\n" + ran.out, HasSubstr(std::string("\n") + name + " ")) << name;
    EXPECT_THAT(ran.out, HasSubstr("1024 jittered samples a pixel"));
}

TEST_F(Cost, MistakesAreNamedTogether) {
    const Ran ran = cost({"--knob", "sppp", "--knob", "shading=blinn", "--stats", "-", "--seconds", "soon"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr("there is no knob \"sppp\"; did you mean \"spp\"?"));
    EXPECT_THAT(ran.err, HasSubstr("\"blinn\" is no value of shading"));
    EXPECT_THAT(ran.err, HasSubstr("--stats: belongs to render"));
    EXPECT_THAT(ran.err, HasSubstr("--seconds: \"soon\" must be"));
    const Ran range = cost({"--knob", "spp=4,15", "--knob", "depth=0.5", "--knob", "hemicube", "--method", "raytrace"});
    EXPECT_EQ(range.code, 2);
    EXPECT_THAT(range.err, HasSubstr("--knob spp=15: --spp: \"15\" must be a square"));
    EXPECT_THAT(range.err, HasSubstr("--knob depth=0.5: --depth"));
    EXPECT_THAT(range.err, HasSubstr("--knob hemicube: belongs to --method radiosity, but --method is raytrace"));
    const Ran shading = cost({"--knob", "shading=phong/1.5", "--knob", "functions=foo", "--knob", "functions", "--knob", "functions"});
    EXPECT_EQ(shading.code, 2);
    EXPECT_THAT(shading.err, HasSubstr("--knob: functions has no values"));
    EXPECT_THAT(shading.err, HasSubstr("--knob: functions is there twice"));
    const Ran fraction = cost({"--knob", "shading=phong/1.5"});
    EXPECT_THAT(fraction.err, HasSubstr("--knob shading=phong/1.5: --subdivide"));
    EXPECT_THAT(fraction.err, Not(HasSubstr("reference"))); // nobody typed its numbers
    EXPECT_FALSE(fs::exists(folder / "report"));
    EXPECT_THAT(run({"cost", "--knob", "spp"}).err, HasSubstr("SCENE is missing"));
}

// A scene that the method cannot draw would be measured with another one.
TEST_F(Cost, AFallbackIsNotMeasured) {
    const Ran ran = run({"cost", scene("[[material]]\nname = \"grey\"\n[[object]]\nshape = \"sphere\"\nmaterial = \"grey\"\n"), "-o",
                         in_folder("report"), "--knob", "hemicube=16", "--size", "32x32"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr("not drawn by the method that the knob belongs to"));
}

// Told before minutes are spent: whatever stands where a file goes, and folders that nobody can make.
TEST_F(Cost, WhatIsInTheWayIsToldFirst) {
    for (const char* name :
         {"report/spp-flip.svg", "report/images/spp-4.png", "report/accel-time.svg", "report/images/accel-reference.png"})
        fs::create_directories(folder / name);
    const Ran ran = cost({"--knob", "spp=4,9", "--knob", "accel", "--size", "32x24"});
    EXPECT_EQ(ran.code, 2);
    for (const char* name : {"spp-flip.svg is a folder; a file goes there", "images/spp-4.png is a folder", "accel-time.svg is a folder",
                             "images/accel-reference.png is a folder"})
        EXPECT_THAT(ran.err, HasSubstr(name));
    const Ran proc = run({"cost", scene(kBall), "-o", "/proc/report", "--knob", "spp=4", "--size", "32x24"});
    EXPECT_EQ(proc.code, 3);
    EXPECT_THAT(proc.err, HasSubstr("/proc/report"));
    EXPECT_EQ(proc.out, "");
}

TEST_F(Cost, WithoutGnuplotAllButThePlotsIsMade) {
    const Ran ran =
        run({"cost", scene(kBall), "-o", in_folder("report"), "--rounds", "2", "--size", "32x24", "--knob", "spp=1,4", "--knob", "model"},
            {{"PATH", "/nowhere"}});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.err,
                HasSubstr("warning: no plots: gnuplot, which draws the SVG files, cannot be run (Debian's package is gnuplot-nox)"));
    EXPECT_LT(ran.err.find("warning: no plots"), ran.err.find("spp: ")); // before anything is measured, and once
    EXPECT_EQ(ran.err.find("warning: no plots"), ran.err.rfind("warning: no plots"));
    EXPECT_EQ(report()["curves"].size(), 2u);
    for (const char* name : {"cost.csv", "report.html", "images/model-phong.png"})
        EXPECT_TRUE(fs::exists(folder / "report" / name)) << name;
    EXPECT_FALSE(fs::exists(folder / "report" / "spp-rmse.svg"));
}

TEST_F(Cost, FloatErrsByItsRoundingsOnly) {
    const Ran ran = cost({"--knob", "precision", "--strict", "--size", "48x36"});
    if (ran.err.find("does not compute in float64") != std::string::npos) GTEST_SKIP() << ran.err;
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto found = errors(report()["curves"][0], "relative rmse");
    EXPECT_GT(found[0], 1e-9);
    EXPECT_LT(found[0], 3e-6); // 20 roundings or so, of which a highlight makes some more
    EXPECT_EQ(found[1], 0);
    const json shading = curve({"--knob", "shading=phong,gouraud/1", "--size", "48x36"});
    EXPECT_THAT(shading["reference"]["command"].get<std::string>(), HasSubstr("--precision float64"));
    EXPECT_THAT(shading["points"][0]["command"].get<std::string>(), Not(HasSubstr("--precision")));
}

TEST_F(Cost, LawsReplaceTheScenesOwn) {
    const json laws = curve({"--knob", "attenuation", "--knob", "model", "--size", "48x36"});
    EXPECT_GT(errors(laws)[0], 0.01); // none
    EXPECT_EQ(errors(laws)[2], 0);    // the reference itself
    const auto models = errors(report()["curves"][1]);
    EXPECT_EQ(models[0], 0);
    EXPECT_GT(models[1], 0.001);
}

} // namespace
} // namespace lightbench::cli
