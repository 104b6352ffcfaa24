// Makes images and reads them back.
#include "gpu/image.h"

#include "gpu/buffer_state.h"
#include "gpu/check.h"
#include "gpu/recorder.h"

#include <vulkan/vulkan_format_traits.hpp>

namespace lightbench::gpu {

ImageState::~ImageState() {
    if (!handle) return;
    view.clear();
    vmaDestroyImage(device->allocator.get(), handle, allocation);
    device->ledger.give(charged);
}

Image::Image() = default;
Image::Image(Image&&) noexcept = default;
Image& Image::operator=(Image&&) noexcept = default;
Image::~Image() = default;

const std::string& Image::name() const {
    return state_->name;
}
vk::Extent2D Image::extent() const {
    return state_->extent;
}
vk::Format Image::format() const {
    return state_->format;
}
unsigned Image::samples() const {
    return state_->samples;
}
std::size_t Image::texel_bytes() const {
    return vk::blockSize(state_->format);
}

vk::ImageAspectFlags aspect_of(vk::Format format) {
    const bool depth = format == vk::Format::eD32Sfloat || format == vk::Format::eD16Unorm;
    return depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
}

namespace {

// The device's own limits for just this image: side, samples, format with this usage.
void require_supported(const ImageState& s, const vk::ImageCreateInfo& info) {
    const std::string what =
        fmt::format("image \"{}\" ({}x{}, {}, {} samples)", s.name, s.extent.width, s.extent.height, vk::to_string(s.format), s.samples);
    vk::ImageFormatProperties can;
    try {
        can = s.device->physical.getImageFormatProperties(info.format, info.imageType, info.tiling, info.usage);
    } catch (const vk::FormatNotSupportedError&) {
        throw EnvironmentError(fmt::format("the device {} has no {} with this usage", s.device->info.name, what));
    }
    const std::uint32_t side = std::min({can.maxExtent.width, can.maxExtent.height, s.device->info.max_image_side});
    if (std::max(s.extent.width, s.extent.height) > side)
        throw EnvironmentError(
            fmt::format("{} is too large for the device {}, whose images have at most {} pixels a side", what, s.device->info.name, side));
    if (!(can.sampleCounts & info.samples))
        throw EnvironmentError(fmt::format("{} has a sample count that the device {} lacks; it has {}", what, s.device->info.name,
                                           vk::to_string(can.sampleCounts)));
}

void allocate(ImageState& s, const vk::ImageCreateInfo& info) {
    const std::string what = fmt::format("image \"{}\"", s.name);
    const vk::DeviceImageMemoryRequirements query{.pCreateInfo = &info};
    const vk::DeviceSize needs = s.device->device.getImageMemoryRequirements(query).memoryRequirements.size;
    s.device->ledger.take(needs, what);
    VmaAllocationCreateInfo where{};
    where.usage = VMA_MEMORY_USAGE_AUTO_PREFER_DEVICE;
    VkImage handle = VK_NULL_HANDLE;
    const VkImageCreateInfo& plain = info;
    const VkResult code = vmaCreateImage(s.device->allocator.get(), &plain, &where, &handle, &s.allocation, nullptr);
    if (code != VK_SUCCESS) s.device->ledger.give(needs);
    throw_unless_success(code, fmt::format("making {} of {}", what, show_bytes(needs)));
    s.handle = handle;
    s.charged = needs;
    set_name(*s.device, s.handle, s.name);
}

} // namespace

Image make_image(Device& device, std::string name, vk::Extent2D extent, vk::Format format, vk::ImageUsageFlags usage, unsigned samples) {
    CHECK(extent.width > 0u, "image \"{}\"", name);
    CHECK(extent.height > 0u, "image \"{}\"", name);
    Image image;
    image.state_ = std::make_unique<ImageState>();
    ImageState& s = *image.state_;
    s.device = &device.state();
    s.name = std::move(name);
    s.extent = extent;
    s.format = format;
    s.samples = samples;
    if (samples == 1) usage |= vk::ImageUsageFlagBits::eTransferSrc | vk::ImageUsageFlagBits::eTransferDst;
    const vk::ImageCreateInfo info{.imageType = vk::ImageType::e2D,
                                   .format = format,
                                   .extent = {extent.width, extent.height, 1},
                                   .mipLevels = 1,
                                   .arrayLayers = 1,
                                   .samples = static_cast<vk::SampleCountFlagBits>(samples),
                                   .usage = usage};
    require_supported(s, info);
    allocate(s, info);
    const vk::ImageSubresourceRange whole{.aspectMask = aspect_of(format), .levelCount = 1, .layerCount = 1};
    s.view = guarded("making an image view", [&] {
        return vk::raii::ImageView(s.device->device,
                                   {.image = s.handle, .viewType = vk::ImageViewType::e2D, .format = format, .subresourceRange = whole});
    });
    set_name(*s.device, *s.view, s.name);
    return image;
}

std::vector<std::byte> read_bytes(Device& device, Image& image, vk::Rect2D rect) {
    std::vector<std::byte> bytes(std::size_t{rect.extent.width} * rect.extent.height * image.texel_bytes());
    Buffer readback = make_buffer(device, image.name() + " (readback)", bytes.size(), {}, Memory::readback);
    Recorder recorder(device);
    recorder.copy_to_buffer(image, readback, rect);
    recorder.submit_and_wait();
    download(device, readback, bytes);
    return bytes;
}

} // namespace lightbench::gpu
