#include "app/view/screen.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <optional>

namespace lightbench::view {
namespace {

vk::raii::Instance make_instance(const vk::raii::Context& context, bool validation) {
    std::uint32_t count = 0;
    const char** wanted = glfwGetRequiredInstanceExtensions(&count);
    if (wanted == nullptr) throw gpu::EnvironmentError("the window system offers no Vulkan surface: its driver lacks VK_KHR_surface");
    std::vector<const char*> extensions(wanted, wanted + count), layers;
    if (validation) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (validation) extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    if (validation) layers.push_back(gpu::kValidationLayer);
    const vk::ValidationFeatureEnableEXT synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    const vk::ValidationFeaturesEXT features{.enabledValidationFeatureCount = 1, .pEnabledValidationFeatures = &synchronization};
    const vk::ApplicationInfo application{.pApplicationName = "lightbench view", .apiVersion = VK_API_VERSION_1_1};
    return {context, vk::InstanceCreateInfo{.pNext = validation ? &features : nullptr,
                                            .pApplicationInfo = &application,
                                            .enabledLayerCount = static_cast<std::uint32_t>(layers.size()),
                                            .ppEnabledLayerNames = layers.data(),
                                            .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                            .ppEnabledExtensionNames = extensions.data()}};
}

// Draws and presents; nothing, if no family does both.
std::optional<std::uint32_t> family_of(const vk::raii::PhysicalDevice& physical, vk::SurfaceKHR surface) {
    const auto families = physical.getQueueFamilyProperties();
    for (std::uint32_t i = 0; i < families.size(); ++i)
        if (families[i].queueFlags & vk::QueueFlagBits::eGraphics && physical.getSurfaceSupportKHR(i, surface)) return i;
    return std::nullopt;
}

bool has_swapchain(const vk::raii::PhysicalDevice& physical) {
    for (const vk::ExtensionProperties& extension : physical.enumerateDeviceExtensionProperties())
        if (std::string_view(extension.extensionName) == VK_KHR_SWAPCHAIN_EXTENSION_NAME) return true;
    return false;
}

void choose_physical(Screen& s, const std::string& preferred) {
    for (vk::raii::PhysicalDevice& physical : vk::raii::PhysicalDevices(s.instance)) {
        const auto family = has_swapchain(physical) ? family_of(physical, *s.surface) : std::nullopt;
        if (!family) continue;
        const bool asked = std::string_view(physical.getProperties().deviceName) == preferred;
        if (*s.physical && !asked) continue;
        s.physical = std::move(physical), s.family = *family;
        if (asked) return;
    }
    if (!*s.physical) throw gpu::EnvironmentError("no Vulkan device can show pictures in a window on this display");
}

vk::raii::Device make_device(const vk::raii::PhysicalDevice& physical, std::uint32_t family) {
    const float priority = 1;
    const char* const extension = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    const vk::DeviceQueueCreateInfo queue{.queueFamilyIndex = family, .queueCount = 1, .pQueuePriorities = &priority};
    return {physical,
            vk::DeviceCreateInfo{
                .queueCreateInfoCount = 1, .pQueueCreateInfos = &queue, .enabledExtensionCount = 1, .ppEnabledExtensionNames = &extension}};
}

} // namespace

Screen open_screen(GLFWwindow* window, const std::string& preferred) {
    return shown("opening the window", [&] {
        Screen s;
        const bool validation = gpu::wants_validation({});
        if (validation) gpu::require_validation_layer(s.context);
        s.instance = make_instance(s.context, validation);
        if (validation) s.messenger = {s.instance, gpu::messenger_info(*s.log)};
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        vk::resultCheck(static_cast<vk::Result>(glfwCreateWindowSurface(*s.instance, window, nullptr, &surface)),
                        "glfwCreateWindowSurface");
        s.surface = {s.instance, surface};
        choose_physical(s, preferred);
        s.device = make_device(s.physical, s.family);
        s.queue = {s.device, s.family, 0};
        return s;
    });
}

Memory allocate(const Screen& screen, const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags properties) {
    const vk::PhysicalDeviceMemoryProperties all = screen.physical.getMemoryProperties();
    for (std::uint32_t i = 0; i < all.memoryTypeCount; ++i)
        if (needs.memoryTypeBits >> i & 1 && (all.memoryTypes[i].propertyFlags & properties) == properties)
            return {{screen.device, vk::MemoryAllocateInfo{.allocationSize = needs.size, .memoryTypeIndex = i}}, needs.size};
    throw gpu::EnvironmentError("the window's Vulkan device has no memory of the kind that pictures need");
}

} // namespace lightbench::view
