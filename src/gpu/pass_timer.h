// Device timestamps around passes, any number of them.
#pragma once

#include "gpu/recorder.h"

#include <vulkan/vulkan_raii.hpp>

namespace lightbench::gpu {

class PassTimer {
  public:
    explicit PassTimer(DeviceState& device) : device_(device) {}
    void begin(const vk::raii::CommandBuffer& commands, std::string_view name); // outside of rendering
    void end(const vk::raii::CommandBuffer& commands);
    Timings read_and_reset(); // once the commands have run

  private:
    DeviceState& device_;
    std::vector<vk::raii::QueryPool> pools_;
    std::vector<std::string> names_;
};

} // namespace lightbench::gpu
