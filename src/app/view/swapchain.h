// The images that a window shows one after the other, and the render pass that draws the interface into them. Inside this folder.
#pragma once

#include "app/view/screen.h"

#include <vector>

namespace lightbench::view {

struct Swapchain {
    vk::Extent2D extent{};
    vk::Format format{};
    bool vsync = true;
    std::uint32_t least_images = 2;
    vk::raii::SwapchainKHR chain{nullptr};
    std::vector<vk::Image> images;
    std::vector<vk::raii::ImageView> views;
    std::vector<vk::raii::Framebuffer> framebuffers;
    std::vector<vk::raii::Semaphore> drawn; // one an image: it may be presented
};

// 8 bits a channel without conversion: pictures and interface are sRGB encoded already.
vk::SurfaceFormatKHR surface_format(const Screen& screen);

// Keeps what is there, goes on to be presented.
vk::raii::RenderPass make_interface_pass(const Screen& screen, vk::Format format);

// False: the window has no area now, `chain` stays as it is. The device is idle.
bool remake(Swapchain& chain, const Screen& screen, vk::RenderPass pass, vk::Extent2D framebuffer, bool vsync);

} // namespace lightbench::view
