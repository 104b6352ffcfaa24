// Collects validation messages.
#include "gpu/validation.h"

#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>

namespace lightbench::gpu {

std::vector<std::string> messages_of(const ValidationLog& log) {
    const std::lock_guard lock(log.mutex);
    return log.messages;
}

bool wants_validation(const DeviceRequest& request) {
    const char* text = std::getenv("LIGHTBENCH_VALIDATION");
    return request.validation || (text && std::string_view(text) == "1");
}

void require_validation_layer(const vk::raii::Context& context) {
    for (const vk::LayerProperties& layer : context.enumerateInstanceLayerProperties())
        if (std::string_view(layer.layerName) == kValidationLayer) return;
    throw EnvironmentError(
        fmt::format("validation was asked for, but {} is not installed (Debian: vulkan-validationlayers)", kValidationLayer));
}

namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto& log = *static_cast<ValidationLog*>(user);
    const std::lock_guard lock(log.mutex);
    fmt::print(stderr, "validation: {}\n", data->pMessage);
    log.messages.emplace_back(data->pMessage);
    return VK_FALSE; // the call goes on
}

} // namespace

// Of type "general" are the loader's remarks on drivers that are not ours: left out.
vk::DebugUtilsMessengerCreateInfoEXT messenger_info(ValidationLog& log) {
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    return {.messageSeverity = Severity::eWarning | Severity::eError,
            .messageType = Type::eValidation | Type::ePerformance,
            .pfnUserCallback = collect,
            .pUserData = &log};
}

} // namespace lightbench::gpu
