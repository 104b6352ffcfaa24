// Descriptor sets of one recording, from pools that are emptied when it is over.
#pragma once

#include "gpu/pass_uses.h"

namespace lightbench::gpu {

class Descriptors {
  public:
    explicit Descriptors(DeviceState& device) : device_(device) {}
    // Sets for the pipeline's live bindings, filled. EnvironmentError if a buffer is beyond the device's storage range.
    std::vector<vk::DescriptorSet> make_sets(const PipelineState& pipeline, const Bindings& bindings);
    void reset();

  private:
    vk::DescriptorSet allocate(vk::DescriptorSetLayout layout);
    DeviceState& device_;
    std::vector<vk::raii::DescriptorPool> pools_;
    std::size_t current_ = 0;
};

} // namespace lightbench::gpu
