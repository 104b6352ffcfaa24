// Writes and reads timestamps.
#include "gpu/pass_timer.h"

#include "gpu/device_state.h"

namespace lightbench::gpu {
namespace {

constexpr std::uint32_t kPassesPerPool = 64; // two timestamps each

} // namespace

void PassTimer::begin(const vk::raii::CommandBuffer& commands, std::string_view name) {
    const std::size_t pool = names_.size() / kPassesPerPool;
    const std::uint32_t slot = static_cast<std::uint32_t>(names_.size() % kPassesPerPool);
    if (pool == pools_.size())
        pools_.emplace_back(device_.device,
                            vk::QueryPoolCreateInfo{.queryType = vk::QueryType::eTimestamp, .queryCount = 2 * kPassesPerPool});
    if (slot == 0) commands.resetQueryPool(*pools_[pool], 0, 2 * kPassesPerPool);
    names_.emplace_back(name);
    // All commands: the clock starts when the passes before have ended.
    commands.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *pools_[pool], 2 * slot);
}

void PassTimer::end(const vk::raii::CommandBuffer& commands) {
    const std::size_t last = names_.size() - 1;
    const std::uint32_t slot = static_cast<std::uint32_t>(last % kPassesPerPool);
    commands.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *pools_[last / kPassesPerPool], 2 * slot + 1);
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
