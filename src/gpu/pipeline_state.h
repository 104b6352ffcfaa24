// What pipelines own, for the sources of this room.
#pragma once

#include "gpu/device_state.h"
#include "gpu/pipeline.h"

#include <chrono>

namespace lightbench::gpu {

// One binding of the pipeline, live in at least one stage.
struct LayoutBinding : ReflectedBinding {
    vk::ShaderStageFlags stages;
};

struct PipelineState {
    DeviceState* device = nullptr;
    std::string name;
    std::vector<Stage> stages;
    std::vector<LayoutBinding> bindings;   // ordered by set, then binding
    std::vector<bool> reads_vertex_buffer; // each of the layouts: has an attribute that is alive
    std::size_t push_size = 0;             // as the caller gives it
    vk::ShaderStageFlags push_stages;      // that still read it; none: pushing does nothing
    std::vector<vk::raii::DescriptorSetLayout> set_layouts;
    vk::raii::PipelineLayout layout{nullptr};
    vk::raii::Pipeline pipeline{nullptr};
};

vk::DescriptorType descriptor_type(BindingKind kind);

// Specialises and reflects one stage; CHECKs the size of its push constants.
const Stage& make_stage(DeviceState& device, const ShaderCode& code, const Constants& constants, std::size_t push_size);

// Fills in bindings, set layouts and the pipeline layout from the stages.
void make_layouts(PipelineState& state);

// Adds the wall time of its life to what the device has spent on making pipelines.
class CreationTimer {
  public:
    explicit CreationTimer(DeviceState& device);
    CreationTimer(const CreationTimer&) = delete;
    ~CreationTimer();

  private:
    DeviceState& device_;
    std::chrono::steady_clock::time_point start_;
};

} // namespace lightbench::gpu
