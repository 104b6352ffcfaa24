// Which device: what each one is, what it lacks, and which one a choice means. The decision itself is pure.
#pragma once

#include "gpu/device.h"

#include <optional>
#include <vulkan/vulkan_raii.hpp>

namespace lightbench::gpu {

struct Candidate {
    DeviceDescription description;
    vk::PhysicalDeviceType type{};
    std::string aliases; // further words that a choice may be part of
};

Candidate describe(const vk::raii::PhysicalDevice& physical);

// The queue family that draws and computes; nothing if there is none.
std::optional<std::uint32_t> queue_family(const vk::raii::PhysicalDevice& physical);

// The index of the candidate that `choice` means: an index, or a part of a name in any case; empty: discrete, integrated, virtual,
// other, CPU, in this order, among those that lack nothing. EnvironmentError with the list of what there is, if none will do.
std::size_t choose(const std::vector<Candidate>& candidates, const std::string& choice);

} // namespace lightbench::gpu
