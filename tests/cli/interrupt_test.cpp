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

// In the middle of the second knob: the first one's curve is a whole report, and of the other no picture is left.
TEST_F(Interrupted, CtrlCKeepsWhatASweepHasMeasured) {
    const std::string ball = scene(kBall), folder_of_report = in_folder("report"), messages = in_folder("messages");
    const pid_t child = ::fork();
    if (child == 0) {
        if (!std::freopen(messages.c_str(), "w", stderr) || !std::freopen("/dev/null", "w", stdout)) ::_exit(99);
        ::execl(LIGHTBENCH_PROGRAM, LIGHTBENCH_PROGRAM, "cost", ball.c_str(), "-o", folder_of_report.c_str(), "--size", "96x72", "--knob",
                "shading=flat,phong", "--knob", "spp=uniform/1,uniform/961", "--rounds", "2", nullptr);
        ::_exit(99);
    }
    const std::filesystem::path images = folder / "report" / "images";
    for (int i = 0; i < 9000 && !std::filesystem::exists(images / "spp-uniform-1.png"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130) << read_text(messages);
    EXPECT_THAT(read_text(messages), HasSubstr("holds what was measured: 1 curve"));
    const auto report = nlohmann::json::parse(read_text(folder / "report" / "cost.json"));
    ASSERT_EQ(report["curves"].size(), 1u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(images), {}), 3);
    for (const auto& point : report["curves"][0]["points"]) EXPECT_TRUE(std::filesystem::exists(folder / "report" / point["image"]));
    EXPECT_TRUE(std::filesystem::exists(folder / "report" / "report.html"));
}

} // namespace
} // namespace lightbench::cli
