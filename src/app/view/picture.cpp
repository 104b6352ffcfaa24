#include "app/view/picture.h"

#include <cmath>
#include <cstring>

namespace lightbench::view {
namespace {

void make_image(PictureOnScreen& p, const Screen& screen) {
    using Usage = vk::ImageUsageFlagBits;
    p.image = {screen.device, vk::ImageCreateInfo{.imageType = vk::ImageType::e2D,
                                                  .format = vk::Format::eR8G8B8A8Unorm,
                                                  .extent = {p.size.width, p.size.height, 1},
                                                  .mipLevels = 1,
                                                  .arrayLayers = 1,
                                                  .samples = vk::SampleCountFlagBits::e1,
                                                  .tiling = vk::ImageTiling::eOptimal,
                                                  .usage = Usage::eTransferDst | Usage::eTransferSrc}};
    p.image_memory = allocate(screen, p.image.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal);
    p.image.bindMemory(*p.image_memory.memory, 0);
}

void make_staging(PictureOnScreen& p, const Screen& screen) {
    using Property = vk::MemoryPropertyFlagBits;
    for (PictureOnScreen::Staging& s : p.staging) {
        s = {};
        s.buffer = {screen.device, vk::BufferCreateInfo{.size = vk::DeviceSize{p.size.width} * p.size.height * 4,
                                                        .usage = vk::BufferUsageFlagBits::eTransferSrc}};
        s.memory = allocate(screen, s.buffer.getMemoryRequirements(), Property::eHostVisible | Property::eHostCoherent);
        s.buffer.bindMemory(*s.memory.memory, 0);
        s.mapped = s.memory.memory.mapMemory(0, s.memory.bytes);
    }
}

// Cuts [a, b] to [0, side] and what it is copied from likewise.
void clip(float& a, float& b, float& from_a, float& from_b, float side) {
    const float scale = (from_b - from_a) / (b - a);
    if (a < 0) from_a -= a * scale, a = 0;
    if (b > side) from_b -= (b - side) * scale, b = side;
}

vk::Offset3D corner(float x, float y, int z) {
    return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y)), z};
}

} // namespace

void set_picture(PictureOnScreen& p, const Screen& screen, const Image8& picture) {
    p.pending = &picture;
    const vk::Extent2D size{picture.width, picture.height};
    if (size == p.size) return;
    if (*p.image) screen.device.waitIdle(); // a frame may still show it
    p.size = size;
    make_image(p, screen);
    make_staging(p, screen);
}

void record_change(const vk::raii::CommandBuffer& commands, vk::Image image, const ImageUse& before, const ImageUse& after) {
    const vk::ImageMemoryBarrier barrier{.srcAccessMask = before.access,
                                         .dstAccessMask = after.access,
                                         .oldLayout = before.layout,
                                         .newLayout = after.layout,
                                         .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                         .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                         .image = image,
                                         .subresourceRange = kWholeImage};
    commands.pipelineBarrier(before.stage, after.stage, {}, {}, {}, barrier);
}

void record_upload(PictureOnScreen& p, const vk::raii::CommandBuffer& commands, unsigned frame) {
    if (p.pending == nullptr) return;
    std::memcpy(p.staging[frame].mapped, p.pending->rgba.data(), p.pending->rgba.size());
    p.pending = nullptr;
    using Layout = vk::ImageLayout;
    using Access = vk::AccessFlagBits;
    using At = vk::PipelineStageFlagBits;
    const ImageUse written{Layout::eTransferDstOptimal, At::eTransfer, Access::eTransferWrite};
    record_change(commands, *p.image, {Layout::eUndefined, At::eTransfer, Access::eTransferRead}, written);
    const vk::BufferImageCopy all{.imageSubresource = {vk::ImageAspectFlagBits::eColor, 0, 0, 1},
                                  .imageExtent = {p.size.width, p.size.height, 1}};
    commands.copyBufferToImage(*p.staging[frame].buffer, *p.image, Layout::eTransferDstOptimal, all);
    record_change(commands, *p.image, written, {Layout::eTransferSrcOptimal, At::eTransfer, Access::eTransferRead});
}

void record_blit(const PictureOnScreen& p, const vk::raii::CommandBuffer& commands, vk::Image target, vk::Extent2D extent, Area from,
                 Area to) {
    clip(to.x0, to.x1, from.x0, from.x1, static_cast<float>(extent.width));
    clip(to.y0, to.y1, from.y0, from.y1, static_cast<float>(extent.height));
    const vk::ImageSubresourceLayers layer{vk::ImageAspectFlagBits::eColor, 0, 0, 1};
    const vk::ImageBlit blit{.srcSubresource = layer,
                             .srcOffsets = {{corner(from.x0, from.y0, 0), corner(from.x1, from.y1, 1)}},
                             .dstSubresource = layer,
                             .dstOffsets = {{corner(to.x0, to.y0, 0), corner(to.x1, to.y1, 1)}}};
    const vk::ImageBlit& b = blit;
    if (b.srcOffsets[0].x >= b.srcOffsets[1].x || b.srcOffsets[0].y >= b.srcOffsets[1].y || b.dstOffsets[0].x >= b.dstOffsets[1].x ||
        b.dstOffsets[0].y >= b.dstOffsets[1].y)
        return; // less than a pixel is left
    const bool smaller = to.x1 - to.x0 < from.x1 - from.x0;
    commands.blitImage(*p.image, vk::ImageLayout::eTransferSrcOptimal, target, vk::ImageLayout::eTransferDstOptimal, blit,
                       smaller ? vk::Filter::eLinear : vk::Filter::eNearest);
}

} // namespace lightbench::view
