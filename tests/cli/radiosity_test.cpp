// Radiosity as its users type it: what it tells of itself, what it shows, and that patience may end at any time.
#include "program.h"

#include "image/files.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace lightbench::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class RadiosityRun : public Cli {
  protected:
    RadiosityRun() : box(in_folder("box.toml")) { EXPECT_EQ(run({"make", "cornell-box", "-o", box}).code, 0); }
    // Coarse, so that it takes a moment.
    Ran render(const std::vector<std::string>& more, const std::string& picture = "x.png") const {
        std::vector<std::string> arguments = {"render", box,       "-o",  in_folder(picture), "--method", "radiosity", "--size",
                                              "64x64",  "--patch", "200", "--element",        "100"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    json stats_of(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = more;
        arguments.insert(arguments.end(), {"--stats", "-"});
        const Ran ran = render(arguments);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return json::parse(ran.out);
    }
    std::string box;
};

TEST_F(RadiosityRun, TellsOfItself) {
    const json stats = stats_of({"--shots", "40"});
    const json& told = stats["radiosity"];
    EXPECT_EQ(stats["method"], "radiosity");
    EXPECT_EQ(told["shots"], 40);
    EXPECT_GT(told["patches"], 50);
    EXPECT_GE(told["elements"], told["patches"]);
    EXPECT_GT(told["unshot"], 0);
    EXPECT_LT(told["unshot"], 1);
    EXPECT_EQ(told["curve"].back()["shots"], 40);
    EXPECT_EQ(stats["plan"]["passes"], json({"hemi-cube", "shots", "raster", "display"}));
}

TEST_F(RadiosityRun, TheFullMatrixTellsHowClosedItIs) {
    const Ran ran = run({"render", box, "-o", in_folder("x.png"), "--method", "radiosity", "--size", "64x64", "--patch", "100", "--solver",
                         "full", "--stats", "-"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json stats = json::parse(ran.out);
    EXPECT_EQ(stats["radiosity"]["unshot"], 0);
    EXPECT_GT(stats["radiosity"]["closure_error"], 0.01); // the box is open in front
}

TEST_F(RadiosityRun, ShowsPatchesFormFactorsAndHemicubes) {
    for (const std::vector<std::string>& what : std::vector<std::vector<std::string>>{
             {"--show", "patches"}, {"--show", "form-factors", "--pick", "32,40"}, {"--show", "hemicube", "--pick", "32,40"}}) {
        const Ran ran = render(what, what[1] + ".png");
        ASSERT_EQ(ran.code, 0) << ran.err;
        const Image8 picture = std::get<Image8>(read_image(in_folder(what[1] + ".png")));
        EXPECT_EQ(picture.width, 64u);
        EXPECT_GT(std::ranges::count_if(picture.rgba, [](unsigned char c) { return c > 60 && c < 255; }), 1000) << what[1];
    }
}

TEST_F(RadiosityRun, WhatCannotBeShownIsSaid) {
    EXPECT_THAT(render({"--show", "hemicube"}).err, HasSubstr("--pick X,Y must say of which patch"));
    const Ran ran = render({"--show", "form-factors", "--pick", "0,0"}); // beside the box
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr("--pick: no surface is seen at pixel 0,0"));
}

TEST_F(RadiosityRun, GoesOnFromItsFile) {
    const std::string file = in_folder("box.lbrad");
    EXPECT_EQ(stats_of({"--shots", "8", "--solution", file})["radiosity"]["shots"], 8);
    EXPECT_EQ(stats_of({"--shots", "20", "--solution", file})["radiosity"]["shots"], 20);
    const Ran other = render({"--hemicube", "32", "--solution", file});
    EXPECT_EQ(other.code, 2);
    EXPECT_THAT(other.err, HasSubstr("is the solution of another scene or of other parameters"));
    write_text(file, "not a solution");
    EXPECT_EQ(render({"--solution", file}).code, 2);
}

TEST_F(RadiosityRun, CtrlCKeepsPictureAndSolution) {
    const std::string picture = in_folder("x.png"), solution = in_folder("x.lbrad"), messages = in_folder("messages");
    const pid_t child = ::fork();
    if (child == 0) {
        if (!std::freopen(messages.c_str(), "w", stderr)) ::_exit(99);
        ::execl(LIGHTBENCH_PROGRAM, LIGHTBENCH_PROGRAM, "render", box.c_str(), "-o", picture.c_str(), "--method", "radiosity", "--until",
                "1e-9", "--hemicube", "256", "--solution", solution.c_str(), nullptr);
        ::_exit(99);
    }
    std::this_thread::sleep_for(std::chrono::seconds(6));
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_THAT(read_text(messages), HasSubstr("of it unshot"));
    EXPECT_EQ(std::get<Image8>(read_image(picture)).width, 512u);
    EXPECT_GT(std::filesystem::file_size(solution), 1000u);
}

TEST_F(Cli, SceneWithoutSourcesHasNoRadiosity) {
    const Ran ran = run(
        {"plan", scene("[[material]]\nname = \"grey\"\n[[object]]\nshape = \"sphere\"\nmaterial = \"grey\"\n"), "--method", "radiosity"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("no material glows and there is no light: drawn by the rasteriser"));
}

} // namespace
} // namespace lightbench::cli
