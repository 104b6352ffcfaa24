// The window's own small Vulkan device: it only shows pictures and the interface, and never waits for the one that renders. Inside this folder.
#pragma once

#include "gpu/validation.h"

#include <vulkan/vulkan_raii.hpp>

struct GLFWwindow;

namespace lightbench::view {

// Runs f; what Vulkan throws becomes a gpu::EnvironmentError that says what we were doing.
template <class F> decltype(auto) shown(std::string_view doing, F&& f) {
    try {
        return f();
    } catch (const vk::SystemError& error) {
        throw gpu::EnvironmentError(fmt::format("the window's Vulkan driver failed while {}: {}", doing, error.what()));
    }
}

// Members are destroyed from the last to the first.
struct Screen {
    std::shared_ptr<gpu::ValidationLog> log = std::make_shared<gpu::ValidationLog>();
    vk::raii::Context context;
    vk::raii::Instance instance{nullptr};
    vk::raii::DebugUtilsMessengerEXT messenger{nullptr};
    vk::raii::SurfaceKHR surface{nullptr};
    vk::raii::PhysicalDevice physical{nullptr};
    vk::raii::Device device{nullptr};
    std::uint32_t family = 0;
    vk::raii::Queue queue{nullptr};
};

// `preferred`: the name of the device that renders; another one is taken if that cannot show anything in this window.
Screen open_screen(GLFWwindow* window, const std::string& preferred);

struct Memory {
    vk::raii::DeviceMemory memory{nullptr};
    vk::DeviceSize bytes = 0;
};

// Of a buffer or an image, bound by the caller.
Memory allocate(const Screen& screen, const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags properties);

} // namespace lightbench::view
