// Buffers: made inside the device's memory budget, filled and read back by the host.
// In: name (for people and debuggers), size, usage, where it lives. Out: an owned buffer; EnvironmentError if the budget is exceeded.
#pragma once

#include "gpu/device.h"

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace lightbench::gpu {

enum class Memory { device, upload, readback }; // on CPU devices all three are the host's memory, and mapped

struct BufferState;

class Buffer {
  public:
    Buffer(); // none
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;
    ~Buffer();

    explicit operator bool() const { return state_ != nullptr; }
    const std::string& name() const;
    vk::DeviceSize size() const; // bytes
    bool as_texel() const;       // has a view of R32G32B32A32_UINT texels; otherwise shaders read it as a storage buffer
    std::byte* mapped();         // null unless host visible. Writes by the host are seen by what is submitted afterwards

    BufferState& state() const { return *state_; } // for this room
  private:
    friend Buffer make_buffer(Device&, std::string, vk::DeviceSize, vk::BufferUsageFlags, Memory);
    friend Buffer make_texel_buffer(Device&, std::string, vk::DeviceSize, vk::BufferUsageFlags, Memory);
    std::unique_ptr<BufferState> state_;
};

// Usage for copies in both directions is added.
Buffer make_buffer(Device& device, std::string name, vk::DeviceSize bytes, vk::BufferUsageFlags usage, Memory memory = Memory::device);

// Read-only scene data for fetch4(): a storage buffer that also has a texel view, if its bytes / 16 fit the device's maxTexelBufferElements.
// bytes must be a multiple of 16 and not 0.
Buffer make_texel_buffer(Device& device, std::string name, vk::DeviceSize bytes, vk::BufferUsageFlags more_usage = {},
                         Memory memory = Memory::device);

// Directly where the memory is mapped, through a staging buffer where not. The buffer must be idle (everything submitted was waited for).
void upload(Device& device, Buffer& buffer, std::span<const std::byte> bytes, vk::DeviceSize offset = 0);
void download(Device& device, Buffer& buffer, std::span<std::byte> bytes, vk::DeviceSize offset = 0);

// The whole buffer as values of T.
template <class T> std::vector<T> download_all(Device& device, Buffer& buffer) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> values(buffer.size() / sizeof(T));
    download(device, buffer, std::as_writable_bytes(std::span(values)));
    return values;
}

// A buffer that holds these values.
template <class T> Buffer make_filled_buffer(Device& device, std::string name, std::span<const T> values, vk::BufferUsageFlags usage) {
    Buffer buffer = make_buffer(device, std::move(name), values.size_bytes(), usage);
    upload(device, buffer, std::as_bytes(values));
    return buffer;
}

} // namespace lightbench::gpu
