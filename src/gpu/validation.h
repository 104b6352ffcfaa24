// The validation layers: whether they are there, and the messenger that collects what they say.
#pragma once

#include "gpu/device.h"

#include <mutex>
#include <vulkan/vulkan_raii.hpp>

namespace lightbench::gpu {

struct ValidationLog {
    mutable std::mutex mutex; // drivers may report from their own threads
    std::vector<std::string> messages;
};

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

// DeviceRequest::validation or LIGHTBENCH_VALIDATION=1.
bool wants_validation(const DeviceRequest& request);

// EnvironmentError if the layer is not installed.
void require_validation_layer(const vk::raii::Context& context);

// Validation and performance messages of severity warning and above go into the log and to standard error. The log must outlive the instance.
vk::DebugUtilsMessengerCreateInfoEXT messenger_info(ValidationLog& log);

} // namespace lightbench::gpu
