// Writes and reads timestamps.
#include "gpu/pass_timer.h"

#include "gpu/device_state.h"

namespace lightbench::gpu {
namespace {

constexpr std::uint32_t kPassesPerPool = 64; // two timestamps each

// Once a context of llvmpipe has drawn, it puts a timestamp off until it next flushes, and so the two around a dispatch come at one time,
// after it (Mesa 22.3, lp_setup_end_query: at once only while the framebuffer is empty). A barrier flushes.
void write_timestamp(const DeviceState& device, const vk::raii::CommandBuffer& commands, vk::QueryPool pool, std::uint32_t slot) {
    using Stage = vk::PipelineStageFlagBits2;
    commands.writeTimestamp2(Stage::eAllCommands, pool, slot); // all commands: the clock starts when the passes before have ended
    if (!device.info.is_cpu) return;
    const vk::MemoryBarrier2 barrier{.srcStageMask = Stage::eAllCommands, .dstStageMask = Stage::eAllCommands};
    commands.pipelineBarrier2({.memoryBarrierCount = 1, .pMemoryBarriers = &barrier});
}

} // namespace

void PassTimer::begin(const vk::raii::CommandBuffer& commands, std::string_view name) {
    const std::size_t pool = names_.size() / kPassesPerPool;
    const std::uint32_t slot = static_cast<std::uint32_t>(names_.size() % kPassesPerPool);
    if (pool == pools_.size())
        pools_.emplace_back(device_.device,
                            vk::QueryPoolCreateInfo{.queryType = vk::QueryType::eTimestamp, .queryCount = 2 * kPassesPerPool});
    if (slot == 0) commands.resetQueryPool(*pools_[pool], 0, 2 * kPassesPerPool);
    names_.emplace_back(name);
    write_timestamp(device_, commands, *pools_[pool], 2 * slot);
}

void PassTimer::end(const vk::raii::CommandBuffer& commands) {
    const std::size_t last = names_.size() - 1;
    const std::uint32_t slot = static_cast<std::uint32_t>(last % kPassesPerPool);
    write_timestamp(device_, commands, *pools_[last / kPassesPerPool], 2 * slot + 1);
}

Timings PassTimer::read_and_reset() {
    Timings timings;
    for (std::size_t first = 0; first < names_.size(); first += kPassesPerPool) {
        const std::size_t passes = std::min<std::size_t>(kPassesPerPool, names_.size() - first);
        const auto [result, ticks] = pools_[first / kPassesPerPool].getResults<std::uint64_t>(
            0, static_cast<std::uint32_t>(2 * passes), 2 * passes * sizeof(std::uint64_t), sizeof(std::uint64_t),
            vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
        for (std::size_t i = 0; i < passes; ++i)
            timings.push_back(
                {names_[first + i], static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]) * device_.info.timestamp_period * 1e-6});
    }
    names_.clear();
    return timings;
}

} // namespace lightbench::gpu
