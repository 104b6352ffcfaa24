// Reads a physical device's properties, holds them against what lightbench requires, and chooses.
#include "gpu/device_choice.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace lightbench::gpu {

std::optional<std::uint32_t> queue_family(const vk::raii::PhysicalDevice& physical) {
    const auto families = physical.getQueueFamilyProperties();
    constexpr auto kBoth = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    for (std::uint32_t i = 0; i < families.size(); ++i)
        if ((families[i].queueFlags & kBoth) == kBoth && families[i].timestampValidBits > 0) return i;
    return {};
}

namespace {

using Properties =
    vk::StructureChain<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceVulkan11Properties, vk::PhysicalDeviceVulkan12Properties>;

std::string show_version(std::uint32_t v) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(v), VK_API_VERSION_MINOR(v), VK_API_VERSION_PATCH(v));
}

std::uint64_t device_local_bytes(const vk::PhysicalDeviceMemoryProperties& memory) {
    std::uint64_t sum = 0;
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if (memory.memoryHeaps[i].flags & vk::MemoryHeapFlagBits::eDeviceLocal) sum += memory.memoryHeaps[i].size;
    return sum;
}

// Vulkan lets a device decline to keep NaN; Vulkan's default rules stay there.
FloatRules float_rules(const Properties& chain) {
    if (chain.get<vk::PhysicalDeviceProperties2>().properties.deviceType == vk::PhysicalDeviceType::eCpu) return {};
    return {.keep_nan = chain.get<vk::PhysicalDeviceVulkan12Properties>().shaderSignedZeroInfNanPreserveFloat32 == VK_TRUE,
            .unfused = true};
}

DeviceInfo read_info(const vk::raii::PhysicalDevice& physical, const Properties& chain) {
    const vk::PhysicalDeviceProperties& p = chain.get<vk::PhysicalDeviceProperties2>().properties;
    const auto& driver = chain.get<vk::PhysicalDeviceVulkan12Properties>();
    return {.name = p.deviceName.data(),
            .driver = driver.driverName.data(),
            .version = fmt::format("{}, {}", show_version(p.apiVersion), driver.driverInfo.data()),
            .is_cpu = p.deviceType == vk::PhysicalDeviceType::eCpu,
            .subgroup_size = chain.get<vk::PhysicalDeviceVulkan11Properties>().subgroupSize,
            .timestamp_period = p.limits.timestampPeriod,
            .max_texel_elements = p.limits.maxTexelBufferElements,
            .max_storage_range = p.limits.maxStorageBufferRange,
            .max_push_bytes = p.limits.maxPushConstantsSize,
            .max_image_side = std::min(p.limits.maxImageDimension2D, p.limits.maxFramebufferWidth),
            .max_group_count = p.limits.maxComputeWorkGroupCount[0],
            .subpixel_bits = p.limits.subPixelPrecisionBits,
            .heap_bytes = device_local_bytes(physical.getMemoryProperties()),
            .sample_counts = p.limits.framebufferColorSampleCounts & p.limits.framebufferDepthSampleCounts,
            .float_rules = float_rules(chain)};
}

bool has_format(const vk::raii::PhysicalDevice& physical, vk::Format format, vk::FormatFeatureFlags features) {
    return (physical.getFormatProperties(format).optimalTilingFeatures & features) == features;
}

// What the program cannot do without; nothing in it is missing from lavapipe or SwiftShader.
std::vector<std::string> read_lacks(const vk::raii::PhysicalDevice& physical, std::uint32_t api_version) {
    std::vector<std::string> lacks;
    auto need = [&](bool has, const char* what) {
        if (!has) lacks.emplace_back(what);
    };
    need(api_version >= VK_API_VERSION_1_3, "Vulkan 1.3");
    need(queue_family(physical).has_value(), "a queue that draws, computes and has timestamps");
    const auto chain =
        physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features, vk::PhysicalDeviceVulkan13Features>();
    need(chain.get<vk::PhysicalDeviceFeatures2>().features.fragmentStoresAndAtomics, "fragmentStoresAndAtomics");
    need(chain.get<vk::PhysicalDeviceVulkan12Features>().scalarBlockLayout, "scalarBlockLayout");
    need(chain.get<vk::PhysicalDeviceVulkan13Features>().dynamicRendering, "dynamicRendering");
    need(chain.get<vk::PhysicalDeviceVulkan13Features>().synchronization2, "synchronization2");
    need(chain.get<vk::PhysicalDeviceVulkan13Features>().maintenance4, "maintenance4");
    using F = vk::FormatFeatureFlagBits;
    need(has_format(physical, vk::Format::eR32G32B32A32Sfloat, F::eColorAttachment | F::eStorageImage), "RGBA32F images to draw into");
    need(has_format(physical, vk::Format::eD32Sfloat, F::eDepthStencilAttachment), "D32F depth images");
    return lacks;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

int rank(vk::PhysicalDeviceType type) {
    switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu: return 0;
    case vk::PhysicalDeviceType::eIntegratedGpu: return 1;
    case vk::PhysicalDeviceType::eVirtualGpu: return 2;
    case vk::PhysicalDeviceType::eOther: return 3;
    default: return 4;
    }
}

std::string list(const std::vector<Candidate>& candidates) {
    std::string text;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const DeviceDescription& d = candidates[i].description;
        text += fmt::format("{}{} {}", i ? ", " : "", i, d.info.name);
        if (!d.lacks.empty()) text += fmt::format(" (lacks {})", fmt::join(d.lacks, ", "));
    }
    return text;
}

bool is_index(const std::string& choice) {
    return choice.size() < 6 && std::ranges::all_of(choice, [](unsigned char c) { return std::isdigit(c); });
}

bool matches(const Candidate& candidate, const std::string& choice) {
    const DeviceInfo& info = candidate.description.info;
    return lower(info.name + "\n" + info.driver + "\n" + candidate.aliases).find(lower(choice)) != std::string::npos;
}

} // namespace

Candidate describe(const vk::raii::PhysicalDevice& physical) {
    const Properties chain =
        physical
            .getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceVulkan11Properties, vk::PhysicalDeviceVulkan12Properties>();
    const vk::PhysicalDeviceProperties& p = chain.get<vk::PhysicalDeviceProperties2>().properties;
    Candidate candidate{{read_info(physical, chain), read_lacks(physical, p.apiVersion)}, p.deviceType, {}};
    // Everybody calls Mesa's CPU driver lavapipe; it calls itself llvmpipe.
    if (chain.get<vk::PhysicalDeviceVulkan12Properties>().driverID == vk::DriverId::eMesaLlvmpipe) candidate.aliases = "lavapipe";
    return candidate;
}

std::size_t choose(const std::vector<Candidate>& candidates, const std::string& choice) {
    if (candidates.empty())
        throw EnvironmentError(
            "no Vulkan device: no driver is installed or VK_DRIVER_FILES names none (Debian: mesa-vulkan-drivers has one for every CPU)");
    std::vector<std::size_t> meant;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (choice.empty() || (is_index(choice) ? std::stoul(choice) == i : matches(candidates[i], choice))) meant.push_back(i);
    if (meant.empty()) throw EnvironmentError(fmt::format("no Vulkan device matches \"{}\"; there is {}", choice, list(candidates)));
    std::erase_if(meant, [&](std::size_t i) { return !candidates[i].description.lacks.empty(); });
    if (meant.empty()) throw EnvironmentError(fmt::format("no Vulkan device will do; there is {}", list(candidates)));
    return *std::ranges::min_element(meant, {}, [&](std::size_t i) { return rank(candidates[i].type); });
}

} // namespace lightbench::gpu
