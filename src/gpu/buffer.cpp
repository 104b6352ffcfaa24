// Makes, fills and reads buffers.
#include "gpu/buffer.h"

#include "gpu/buffer_state.h"
#include "gpu/check.h"
#include "gpu/recorder.h"

namespace lightbench::gpu {

BufferState::~BufferState() {
    if (!handle) return;
    view.clear();
    vmaDestroyBuffer(device->allocator.get(), handle, allocation);
    device->ledger.give(charged);
}

Buffer::Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;
Buffer::~Buffer() = default;

const std::string& Buffer::name() const {
    return state_->name;
}
vk::DeviceSize Buffer::size() const {
    return state_->size;
}
bool Buffer::as_texel() const {
    return static_cast<bool>(*state_->view);
}
std::byte* Buffer::mapped() {
    return state_->mapped;
}

namespace {

VmaAllocationCreateInfo placement(Memory memory, bool is_cpu) {
    VmaAllocationCreateInfo info{};
    info.usage = memory == Memory::device ? VMA_MEMORY_USAGE_AUTO_PREFER_DEVICE : VMA_MEMORY_USAGE_AUTO_PREFER_HOST;
    if (memory == Memory::upload) info.flags = VMA_ALLOCATION_CREATE_HOST_ACCESS_SEQUENTIAL_WRITE_BIT;
    if (memory == Memory::readback || is_cpu) info.flags = VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT;
    if (info.flags != 0) info.flags |= VMA_ALLOCATION_CREATE_MAPPED_BIT;
    return info;
}

void allocate(BufferState& s, const vk::BufferCreateInfo& info, Memory memory) {
    const std::string what = fmt::format("buffer \"{}\"", s.name);
    const vk::DeviceBufferMemoryRequirements query{.pCreateInfo = &info};
    const vk::DeviceSize needs = s.device->device.getBufferMemoryRequirements(query).memoryRequirements.size;
    s.device->ledger.take(needs, what);
    const VmaAllocationCreateInfo where = placement(memory, s.device->info.is_cpu);
    VkBuffer handle = VK_NULL_HANDLE;
    VmaAllocationInfo result{};
    const VkBufferCreateInfo& plain = info;
    const VkResult code = vmaCreateBuffer(s.device->allocator.get(), &plain, &where, &handle, &s.allocation, &result);
    if (code != VK_SUCCESS) s.device->ledger.give(needs);
    throw_unless_success(code, fmt::format("making {} of {}", what, show_bytes(needs)));
    s.handle = handle;
    s.charged = needs;
    s.mapped = static_cast<std::byte*>(result.pMappedData);
    set_name(*s.device, s.handle, s.name);
}

} // namespace

Buffer make_buffer(Device& device, std::string name, vk::DeviceSize bytes, vk::BufferUsageFlags usage, Memory memory) {
    CHECK(bytes > 0u, "buffer \"{}\"", name);
    Buffer buffer;
    buffer.state_ = std::make_unique<BufferState>();
    BufferState& s = *buffer.state_;
    s.device = &device.state();
    s.name = std::move(name);
    s.size = bytes;
    s.usage = usage | vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst;
    allocate(s, {.size = bytes, .usage = s.usage}, memory);
    return buffer;
}

Buffer make_texel_buffer(Device& device, std::string name, vk::DeviceSize bytes, vk::BufferUsageFlags more_usage, Memory memory) {
    CHECK(bytes % 16 == 0u, "texel buffer \"{}\"", name);
    const bool fits = device.fits_texel_buffer(bytes);
    const vk::BufferUsageFlags texel = fits ? vk::BufferUsageFlagBits::eUniformTexelBuffer : vk::BufferUsageFlags();
    Buffer buffer = make_buffer(device, std::move(name), bytes, more_usage | texel | vk::BufferUsageFlagBits::eStorageBuffer, memory);
    if (!fits) return buffer;
    BufferState& s = buffer.state();
    s.view = guarded("making a texel view", [&] {
        return vk::raii::BufferView(s.device->device,
                                    {.buffer = s.handle, .format = vk::Format::eR32G32B32A32Uint, .range = VK_WHOLE_SIZE});
    });
    set_name(*s.device, *s.view, s.name);
    return buffer;
}

void upload(Device& device, Buffer& buffer, std::span<const std::byte> bytes, vk::DeviceSize offset) {
    BufferState& s = buffer.state();
    CHECK(offset + bytes.size() <= s.size, "buffer \"{}\"", s.name);
    if (bytes.empty()) return;
    if (s.mapped) {
        std::memcpy(s.mapped + offset, bytes.data(), bytes.size());
        throw_unless_success(vmaFlushAllocation(s.device->allocator.get(), s.allocation, offset, bytes.size()), "flushing a buffer");
        return;
    }
    Buffer staging = make_buffer(device, s.name + " (staging)", bytes.size(), {}, Memory::upload);
    upload(device, staging, bytes);
    Recorder recorder(device);
    recorder.copy(staging, buffer, bytes.size(), 0, offset);
    recorder.submit_and_wait();
}

void download(Device& device, Buffer& buffer, std::span<std::byte> bytes, vk::DeviceSize offset) {
    BufferState& s = buffer.state();
    CHECK(offset + bytes.size() <= s.size, "buffer \"{}\"", s.name);
    if (bytes.empty()) return;
    if (s.mapped) {
        throw_unless_success(vmaInvalidateAllocation(s.device->allocator.get(), s.allocation, offset, bytes.size()), "reading a buffer");
        std::memcpy(bytes.data(), s.mapped + offset, bytes.size());
        return;
    }
    Buffer staging = make_buffer(device, s.name + " (staging)", bytes.size(), {}, Memory::readback);
    Recorder recorder(device);
    recorder.copy(buffer, staging, bytes.size(), offset, 0);
    recorder.submit_and_wait();
    download(device, staging, bytes);
}

} // namespace lightbench::gpu
