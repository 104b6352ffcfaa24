// A rendered picture on the window's device: uploaded when it changes, copied into the window scaled. Inside this folder.
#pragma once

#include "app/view/screen.h"
#include "image/image.h"

#include <array>

namespace lightbench::view {

constexpr unsigned kFramesInFlight = 2;
constexpr vk::ImageSubresourceRange kWholeImage{vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};

// How an image is used before or after a barrier.
struct ImageUse {
    vk::ImageLayout layout{};
    vk::PipelineStageFlags stage{};
    vk::AccessFlags access{};
};
void record_change(const vk::raii::CommandBuffer& commands, vk::Image image, const ImageUse& before, const ImageUse& after);

struct PictureOnScreen {
    vk::Extent2D size{};
    vk::raii::Image image{nullptr};
    Memory image_memory{};
    struct Staging {
        vk::raii::Buffer buffer{nullptr};
        Memory memory{};
        void* mapped = nullptr;
    };
    std::array<Staging, kFramesInFlight> staging{}; // the frame before may still read its own
    const Image8* pending = nullptr;                // to be copied by the next frame; the caller's, alive until then
};

// Takes the picture's size; if it changes from another picture's, waits for the device.
void set_picture(PictureOnScreen& p, const Screen& screen, const Image8& picture);

// Commands that bring a pending picture to the device.
void record_upload(PictureOnScreen& p, const vk::raii::CommandBuffer& commands, unsigned frame);

struct Area {
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0; // pixels
};

// Part `from` of the picture into `to` of the target, which is in transfer-destination layout; clipped to `extent`.
void record_blit(const PictureOnScreen& p, const vk::raii::CommandBuffer& commands, vk::Image target, vk::Extent2D extent, Area from,
                 Area to);

} // namespace lightbench::view
