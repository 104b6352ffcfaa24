// Images: one mip level, one layer, inside the device's memory budget; and their way back to the host.
// In: name, extent, format, usage, samples. Out: an owned image with its view; EnvironmentError if the budget is exceeded.
#pragma once

#include "gpu/buffer.h"

namespace lightbench::gpu {

struct ImageState;

class Image {
  public:
    Image(); // none
    Image(Image&&) noexcept;
    Image& operator=(Image&&) noexcept;
    ~Image();

    explicit operator bool() const { return state_ != nullptr; }
    const std::string& name() const;
    vk::Extent2D extent() const; // pixels
    vk::Format format() const;
    unsigned samples() const;
    std::size_t texel_bytes() const; // of one sample

    ImageState& state() const { return *state_; } // for this room
  private:
    friend Image make_image(Device&, std::string, vk::Extent2D, vk::Format, vk::ImageUsageFlags, unsigned);
    std::unique_ptr<ImageState> state_;
};

// Usage for copies in both directions is added to images of one sample. EnvironmentError where the device has no such image
// (side, format with this usage, sample count), saying which.
Image make_image(Device& device, std::string name, vk::Extent2D extent, vk::Format format, vk::ImageUsageFlags usage, unsigned samples = 1);

// Colour images of one sample, row by row from the upper left, through a readback buffer and a submit of its own.
std::vector<std::byte> read_bytes(Device& device, Image& image, vk::Rect2D rect);

template <class T> std::vector<T> read_image(Device& device, Image& image, vk::Rect2D rect) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<std::byte> bytes = read_bytes(device, image, rect);
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

template <class T> std::vector<T> read_image(Device& device, Image& image) {
    return read_image<T>(device, image, {{0, 0}, image.extent()});
}

} // namespace lightbench::gpu
