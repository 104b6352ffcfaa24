// What buffers and images own, and what the recorder remembers about them.
#pragma once

#include "gpu/access.h"
#include "gpu/device_state.h"
#include "gpu/image.h"

namespace lightbench::gpu {

struct BufferState {
    DeviceState* device = nullptr;
    std::string name;
    vk::DeviceSize size = 0;    // as asked for
    vk::DeviceSize charged = 0; // as taken from the budget
    vk::BufferUsageFlags usage;
    vk::Buffer handle;
    VmaAllocation allocation = nullptr;
    std::byte* mapped = nullptr;
    vk::raii::BufferView view{nullptr}; // of texels
    History history;
    BufferState() = default;
    BufferState(const BufferState&) = delete;
    ~BufferState();
};

struct ImageState {
    DeviceState* device = nullptr;
    std::string name;
    vk::Extent2D extent;
    vk::Format format{};
    unsigned samples = 1;
    vk::DeviceSize charged = 0;
    vk::Image handle;
    VmaAllocation allocation = nullptr;
    vk::raii::ImageView view{nullptr};
    History history;
    ImageState() = default;
    ImageState(const ImageState&) = delete;
    ~ImageState();
};

vk::ImageAspectFlags aspect_of(vk::Format format);

} // namespace lightbench::gpu
