// Compute passes, copies and submits. (Draw passes: draw_pass.cpp.)
#include "gpu/recorder.h"

#include "gpu/check.h"
#include "gpu/recorder_state.h"

namespace lightbench::gpu {
namespace {

using Stage2 = vk::PipelineStageFlagBits2;
using Access2 = vk::AccessFlagBits2;

constexpr Access copy_read(vk::ImageLayout layout = vk::ImageLayout::eUndefined) {
    return {Stage2::eAllTransfer, Access2::eTransferRead, false, layout};
}
constexpr Access copy_write(vk::ImageLayout layout = vk::ImageLayout::eUndefined) {
    return {Stage2::eAllTransfer, Access2::eTransferWrite, true, layout};
}

vk::raii::CommandBuffer make_commands(const DeviceState& device, const vk::raii::CommandPool& pool) {
    vk::raii::CommandBuffers made(device.device,
                                  {.commandPool = *pool, .level = vk::CommandBufferLevel::ePrimary, .commandBufferCount = 1});
    return std::move(made.front());
}

} // namespace

RecorderState::RecorderState(DeviceState& d)
    : device(d), pool(d.device, {.flags = vk::CommandPoolCreateFlagBits::eTransient, .queueFamilyIndex = d.family}),
      commands(make_commands(d, pool)), fence(d.device, vk::FenceCreateInfo{}), descriptors(d), timer(d) {}

void begin_pass(RecorderState& r, std::string_view name, PassUses& uses) {
    if (!r.recording) r.commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    r.recording = true;
    const std::string label(name);
    if (r.device.names) r.commands.beginDebugUtilsLabelEXT({.pLabelName = label.c_str()});
    uses.record_barriers(r.commands);
    r.timer.begin(r.commands, name);
}

void end_pass(RecorderState& r) {
    r.timer.end(r.commands);
    if (r.device.names) r.commands.endDebugUtilsLabelEXT();
}

Recorder::Recorder(Device& device)
    : state_(guarded("making a recorder", [&] { return std::make_unique<RecorderState>(device.state()); })) {}
Recorder::Recorder(Recorder&&) noexcept = default;
Recorder& Recorder::operator=(Recorder&&) noexcept = default;
Recorder::~Recorder() = default;

void Recorder::compute(std::string_view name, const ComputePipeline& pipeline, const Bindings& bindings, std::span<const std::byte> push,
                       Groups groups) {
    const PipelineState& p = pipeline.state();
    CHECK(push.size() == p.push_size, "{}: push constants of {}", name, p.name);
    for (const std::uint32_t count : {groups.x, groups.y, groups.z}) {
        CHECK(count > 0u, "{}", name);
        CHECK(count <= state_->device.info.max_group_count, "{}: more work groups than the device allows", name);
    }
    check_names({&p}, bindings);
    PassUses uses;
    uses.add(p, bindings);
    guarded(fmt::format("recording the pass {}", name), [&] {
        const std::vector<vk::DescriptorSet> sets = state_->descriptors.make_sets(p, bindings);
        begin_pass(*state_, name, uses);
        const vk::raii::CommandBuffer& commands = state_->commands;
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *p.pipeline);
        if (!sets.empty()) commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *p.layout, 0, sets, {});
        if (p.push_stages)
            commands.pushConstants<std::byte>(*p.layout, p.push_stages, 0, {static_cast<std::uint32_t>(push.size()), push.data()});
        commands.dispatch(groups.x, groups.y, groups.z);
        end_pass(*state_);
    });
}

void Recorder::copy(Buffer& from, Buffer& to, vk::DeviceSize bytes, vk::DeviceSize from_offset, vk::DeviceSize to_offset) {
    CHECK(from_offset + bytes <= from.size(), "copy of \"{}\"", from.name());
    CHECK(to_offset + bytes <= to.size(), "copy to \"{}\"", to.name());
    PassUses uses;
    uses.add(from.state(), copy_read());
    uses.add(to.state(), copy_write());
    begin_pass(*state_, "copy " + from.name(), uses);
    state_->commands.copyBuffer(from.state().handle, to.state().handle, vk::BufferCopy{from_offset, to_offset, bytes});
    end_pass(*state_);
}

void Recorder::copy_to_buffer(Image& image, Buffer& buffer, vk::Rect2D rect) {
    const ImageState& s = image.state();
    CHECK(s.samples == 1u, "image \"{}\" must be resolved first", s.name);
    CHECK(rect.offset.x + rect.extent.width <= s.extent.width, "image \"{}\"", s.name);
    CHECK(rect.offset.y + rect.extent.height <= s.extent.height, "image \"{}\"", s.name);
    CHECK(std::size_t{rect.extent.width} * rect.extent.height * image.texel_bytes() <= buffer.size(), "copy to \"{}\"", buffer.name());
    PassUses uses;
    uses.add(image.state(), copy_read(vk::ImageLayout::eTransferSrcOptimal));
    uses.add(buffer.state(), copy_write());
    begin_pass(*state_, "copy " + s.name, uses);
    const vk::BufferImageCopy region{.imageSubresource = {.aspectMask = aspect_of(s.format), .layerCount = 1},
                                     .imageOffset = {rect.offset.x, rect.offset.y, 0},
                                     .imageExtent = {rect.extent.width, rect.extent.height, 1}};
    state_->commands.copyImageToBuffer(s.handle, vk::ImageLayout::eTransferSrcOptimal, buffer.state().handle, region);
    end_pass(*state_);
}

void Recorder::fill(Buffer& buffer, std::uint32_t value) {
    PassUses uses;
    uses.add(buffer.state(), copy_write());
    begin_pass(*state_, "fill " + buffer.name(), uses);
    state_->commands.fillBuffer(buffer.state().handle, 0, VK_WHOLE_SIZE, value);
    end_pass(*state_);
}

void Recorder::clear(Image& image, vk::ClearColorValue color) {
    PassUses uses;
    uses.add(image.state(), copy_write(vk::ImageLayout::eTransferDstOptimal));
    begin_pass(*state_, "clear " + image.name(), uses);
    const vk::ImageSubresourceRange whole{.aspectMask = vk::ImageAspectFlagBits::eColor, .levelCount = 1, .layerCount = 1};
    state_->commands.clearColorImage(image.state().handle, vk::ImageLayout::eTransferDstOptimal, color, whole);
    end_pass(*state_);
}

namespace {

// In slices of a second: a driver that is stuck for good can then be told from one that works.
void wait(const DeviceState& device, const vk::raii::Fence& fence) {
    constexpr std::uint64_t kSlice = 1'000'000'000;
    while (device.device.waitForFences(*fence, true, kSlice) == vk::Result::eTimeout) {
    }
    device.device.resetFences(*fence);
}

} // namespace

Timings Recorder::submit_and_wait() {
    RecorderState& r = *state_;
    if (!r.recording) return {};
    return guarded("waiting for the device", [&] {
        const vk::MemoryBarrier2 to_host{.srcStageMask = Stage2::eAllCommands,
                                         .srcAccessMask = Access2::eMemoryWrite,
                                         .dstStageMask = Stage2::eHost,
                                         .dstAccessMask = Access2::eHostRead};
        r.commands.pipelineBarrier2({.memoryBarrierCount = 1, .pMemoryBarriers = &to_host});
        r.commands.end();
        r.recording = false;
        const vk::CommandBufferSubmitInfo commands{.commandBuffer = *r.commands};
        r.device.queue.submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1, .pCommandBufferInfos = &commands}, *r.fence);
        wait(r.device, r.fence);
        Timings timings = r.timer.read_and_reset();
        r.pool.reset();
        r.descriptors.reset();
        return timings;
    });
}

} // namespace lightbench::gpu
