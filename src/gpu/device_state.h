// What a Device owns, for the sources of this room, and how Vulkan's errors become sentences.
#pragma once

#include "gpu/device.h"
#include "gpu/memory_budget.h"
#include "gpu/pipeline.h"
#include "gpu/pipeline_cache.h"
#include "gpu/stage_cache.h"
#include "gpu/validation.h"
#include "gpu/vma.h"

#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vulkan/vulkan_raii.hpp>

namespace lightbench::gpu {

struct AllocatorDelete {
    void operator()(VmaAllocator_T* allocator) const { vmaDestroyAllocator(allocator); }
};

// Members are destroyed from the last to the first.
struct DeviceState {
    DeviceInfo info;
    std::shared_ptr<ValidationLog> log = std::make_shared<ValidationLog>();
    vk::raii::Context context;
    vk::raii::Instance instance{nullptr};
    vk::raii::DebugUtilsMessengerEXT messenger{nullptr};
    vk::raii::PhysicalDevice physical{nullptr};
    vk::raii::Device device{nullptr};
    std::uint32_t family = 0;
    vk::raii::Queue queue{nullptr};
    std::unique_ptr<VmaAllocator_T, AllocatorDelete> allocator;
    MemoryLedger ledger;
    vk::raii::Sampler nearest{nullptr};
    std::optional<CacheFile> cache_file; // none: LIGHTBENCH_NO_CACHE=1 or no folder
    vk::raii::PipelineCache cache{nullptr};
    StageCache stage_cache{cache_folder()};
    std::map<std::pair<const std::uint32_t*, Constants>, Stage> stages;      // specialised, by shader and constants
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> replaced; // modules in place of the program's own
    Constants replaced_constants;
    std::set<std::string> used;
    double pipeline_milliseconds = 0;
    explicit DeviceState(vk::raii::Context loader) : context(std::move(loader)) {}
    bool names = false; // VK_EXT_debug_utils is on
};

// "the device ran out of memory while making the image radiance".
[[noreturn]] void rethrow(const vk::SystemError& error, std::string_view doing);

// Runs f; an error of Vulkan becomes an EnvironmentError that says what we were doing.
template <class F> decltype(auto) guarded(std::string_view doing, F&& f) {
    try {
        return f();
    } catch (const vk::SystemError& error) {
        rethrow(error, doing);
    }
}

void throw_unless_success(VkResult result, std::string_view doing);

// For debuggers and validation messages.
void set_name(const DeviceState& device, vk::ObjectType type, std::uint64_t handle, const std::string& name);

template <class Handle> void set_name(const DeviceState& device, Handle handle, const std::string& name) {
    set_name(device, Handle::objectType, reinterpret_cast<std::uint64_t>(static_cast<typename Handle::CType>(handle)), name);
}

} // namespace lightbench::gpu
