// Pictures that are made while somebody loses patience: Ctrl-C leaves a whole picture, and kill leaves none or a whole one.
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

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Interrupted : public Cli {
  protected:
    // Renders the ball with far more samples than there is patience for; after so many seconds the signal comes. Returns what waitpid tells.
    int render_until(int signal, double seconds) const {
        const std::string ball = scene(kBall), picture = in_folder("x.png"), messages = in_folder("messages"),
                          stats = in_folder("stats.json");
        const pid_t child = ::fork();
        if (child == 0) {
            if (!std::freopen(messages.c_str(), "w", stderr)) ::_exit(99);
            ::execl(LIGHTBENCH_PROGRAM, LIGHTBENCH_PROGRAM, "render", ball.c_str(), "-o", picture.c_str(), "--method", "raytrace", "--size",
                    "640x480", "--spp", "1024", "--sampling", "jittered", "--progress", "always", "--stats", stats.c_str(), nullptr);
            ::_exit(99);
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        ::kill(child, signal);
        int status = 0;
        ::waitpid(child, &status, 0);
        return status;
    }
};

TEST_F(Interrupted, CtrlCKeepsWhatThereIs) {
    const int status = render_until(SIGINT, 8);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    const std::string messages = read_text(in_folder("messages"));
    EXPECT_THAT(messages, HasSubstr("interrupted: "));
    EXPECT_THAT(messages, HasSubstr("% of the picture"));
    EXPECT_EQ(std::get<Image8>(read_image(in_folder("x.png"))).width, 640u);
    EXPECT_THAT(files(), ElementsAre("messages", "scene.toml", "stats.json", "x.png"));
    const auto stats = nlohmann::json::parse(read_text(in_folder("stats.json")));
    EXPECT_GT(stats["image"]["done"], 0);
    EXPECT_LT(stats["image"]["done"], 1);
}

// Whenever it comes, even before anything is drawn: nothing, or a whole picture.
TEST_F(Interrupted, CtrlCAtAnyTimeLeavesNoTruncatedPicture) {
    for (const double seconds : {0.05, 0.6, 1.4, 2.3}) {
        const int status = render_until(SIGINT, seconds);
        EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 130) << seconds;
        for (const std::string& name : files()) EXPECT_THAT(name, AnyOf("messages", "scene.toml", "stats.json", "x.png"));
        if (!std::filesystem::exists(in_folder("x.png"))) continue;
        EXPECT_EQ(std::get<Image8>(read_image(in_folder("x.png"))).height, 480u);
    }
}

TEST_F(Interrupted, KillLeavesNoTruncatedPicture) {
    for (const double seconds : {3.0, 3.7, 4.3}) {
        EXPECT_TRUE(WIFSIGNALED(render_until(SIGKILL, seconds)));
        if (!std::filesystem::exists(in_folder("x.png"))) continue;
        EXPECT_EQ(std::get<Image8>(read_image(in_folder("x.png"))).height, 480u);
    }
}

// A sweep that would take ten minutes: what was measured until then is a whole report.
TEST_F(Interrupted, CtrlCKeepsWhatASweepHasMeasured) {
    const std::string ball = scene(kBall), folder_of_report = in_folder("report"), messages = in_folder("messages");
    const pid_t child = ::fork();
    if (child == 0) {
        if (!std::freopen(messages.c_str(), "w", stderr) || !std::freopen("/dev/null", "w", stdout)) ::_exit(99);
        ::execl(LIGHTBENCH_PROGRAM, LIGHTBENCH_PROGRAM, "cost", ball.c_str(), "-o", folder_of_report.c_str(), "--size", "32x24", "--knob",
                "spp=uniform/1", "--knob", "shading=flat,phong", "--rounds", "10000", "--seconds", "300", nullptr);
        ::_exit(99);
    }
    // The second knob's first round follows its last picture, once the first has settled or not.
    for (int i = 0; i < 900 && !std::filesystem::exists(folder / "report" / "images" / "shading-phong.png"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_THAT(WEXITSTATUS(status), AnyOf(0, 130)); // 0: it had settled
    const auto report = nlohmann::json::parse(read_text(folder / "report" / "cost.json"));
    EXPECT_GE(report["curves"].size(), 1u);
    for (const auto& curve : report["curves"])
        for (const auto& point : curve["points"]) EXPECT_TRUE(std::filesystem::exists(folder / "report" / point["image"]));
}

} // namespace
} // namespace lightbench::cli
