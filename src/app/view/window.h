// The window of the system: opened and closed, and what hands did to it since it was asked last. GLFW stays in this folder.
#pragma once

#include "app/view/keys.h"

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

struct GLFWwindow;

namespace lightbench::view {

struct Input {
    std::vector<const KeyRow*> pressed; // in their order
    std::vector<std::filesystem::path> dropped;
};

class Window {
  public:
    // `picture`: pixels that the picture wants, `panel`: beside it. Throws gpu::EnvironmentError without a display.
    Window(const std::string& title, glm::uvec2 picture, unsigned panel);
    ~Window();
    Window(const Window&) = delete;
    GLFWwindow* handle() const { return window_; }
    // Waits for something to happen, for so many seconds at most.
    Input wait(double seconds);
    bool held(Action action) const; // its key is down
    bool closing() const;
    glm::ivec2 framebuffer() const; // pixels; 0: minimised
    float scale() const;            // of the interface, on screens with more pixels than usual
    void set_title(const std::string& title);
    void hide();
    static void wake(); // from any thread: ends wait()

  private:
    GLFWwindow* window_ = nullptr;
    Input input_;
};

} // namespace lightbench::view
