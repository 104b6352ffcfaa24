// Shows one frame of the window: pictures where they are placed, the interface over them. Vulkan and the interface's backend stay inside.
#pragma once

#include "image/image.h"

#include <memory>
#include <span>
#include <string>

struct GLFWwindow;

namespace lightbench::gpu {
struct ValidationLog;
}

namespace lightbench::view {

// Framebuffer pixels of the window, and pixels of the picture that fill them.
struct Placement {
    unsigned picture = 0; // slot
    float to_x0 = 0, to_y0 = 0, to_x1 = 0, to_y1 = 0;
    float from_x0 = 0, from_y0 = 0, from_x1 = 0, from_y1 = 0;
};

struct PresenterParts;

// One at a time: the interface's backend is global. The interface's context exists.
class Presenter {
  public:
    Presenter(GLFWwindow* window, const std::string& device);
    ~Presenter();
    Presenter(const Presenter&) = delete;

    void set_picture(unsigned slot, std::shared_ptr<const Image8> picture); // 2 slots
    void set_vsync(bool on);
    void begin_frame();
    // Draws what ImGui::Render() left. False: nothing was shown; the window has no area, or the screen and the driver are not done with the
    // frames before.
    bool present(std::span<const Placement> pictures);
    std::shared_ptr<const gpu::ValidationLog> validation_log() const;
    bool waits_for_screen() const; // if it is told to: a driver on the CPU copies into the window

  private:
    std::unique_ptr<PresenterParts> parts_;
};

} // namespace lightbench::view
