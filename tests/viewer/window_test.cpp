// The viewer's window where things are not as on most desktops: nobody maps it, the screen has many pixels, files are dropped on it; and whether
// hands ever wait for it.
#include "screen.h"
#include "x11.h"

#include "app/view/window.h"

#include <GLFW/glfw3.h>
#include <cstdlib>
#include <gmock/gmock.h>

namespace lightbench::viewer {
namespace {

class Windowed : public Viewer {
  protected:
    std::string scene() const {
        write_text(folder / "scene.toml", ball_scene(160, 120));
        return (folder / "scene.toml").string();
    }
};

// GLFW 3.3 waits for the window to be seen, and for nothing else while other events are queued.
TEST_F(Windowed, IsNotAwaitedWhereNobodyMapsIt) {
    if (IsSkipped()) return;
    stop_manager();
    XServer server(display);
    if (!server.open()) GTEST_SKIP() << "no Xlib";
    server.refuse_windows();
    launch({}, scene());
    expect("first-frame", 40);
    expect("settled", 40);
    EXPECT_EQ(terminate(), 128 + 15);
}

// Without a manager nobody gives the keyboard to a window but the window itself.
TEST_F(Windowed, TakesKeysWhereNobodyManagesWindows) {
    if (IsSkipped()) return;
    stop_manager();
    launch({}, scene());
    expect("settled", 40);
    key("1");
    EXPECT_THAT(expect("action "), testing::HasSubstr("shade once a polygon"));
    EXPECT_EQ(quit(), 0);
}

TEST_F(Windowed, IsAsLargeAsTheScreensPixelsAskFor) {
    if (IsSkipped()) return;
    XServer server(display);
    if (!server.open()) GTEST_SKIP() << "no Xlib";
    server.set_resources("Xft.dpi: 192\n");
    start({"--size", "160x120"}, scene());
    expect("settled");
    EXPECT_THAT(tool("getwindowgeometry " + window), testing::HasSubstr("Geometry: 1052x240")) << "(366 + 160) x 120, twice";
    tool("mousemove --window " + window + " 832 60 click 1");
    EXPECT_EQ(expect("click "), "50,30");
    EXPECT_EQ(quit(), 0);
}

// As GLFW calls it once a file lies on the window.
TEST_F(Windowed, GetsDroppedFiles) {
    if (IsSkipped()) return;
    ::setenv("DISPLAY", display.c_str(), 1);
    view::Window other("drop", {64, 48}, 0);
    ::unsetenv("DISPLAY");
    const GLFWdropfun drop = glfwSetDropCallback(other.handle(), nullptr);
    ASSERT_NE(drop, nullptr);
    const char* files[] = {"/tmp/a scene.toml", "b.nff"};
    drop(other.handle(), 2, files);
    EXPECT_THAT(other.wait(0).dropped, testing::ElementsAre("/tmp/a scene.toml", "b.nff"));
    EXPECT_TRUE(other.wait(0).dropped.empty()) << "once";
}

// First uses of pipelines, whole pictures of rays and solutions that take seconds: all beside the window.
TEST_F(Windowed, NeverWaitsForPictures) {
    if (IsSkipped()) return;
    start({"--size", "480x270"}, LIGHTBENCH_SOURCE "/assets/scenes/default.toml");
    expect("settled", 40);
    for (const char* name : {"5", "o", "6", "4", "2", "m"}) key(name), expect("action ");
    key("5");
    tool("mousemove --window " + window + " 500 100 mousedown 1 mousemove_relative 20 10 sleep 0.2 mousemove_relative 20 10 mouseup 1");
    expect("settled", 50);
    EXPECT_EQ(quit(), 0);
    const std::string end = log().substr(log().rfind("longest block ") + 14);
    fmt::print("longest block: {}", end);
    EXPECT_LT(std::stod(end), 2000) << "asked: 200 ms, where nothing else runs on two cores";
}

} // namespace
} // namespace lightbench::viewer
