// What a Recorder owns, for the sources of this room.
#pragma once

#include "gpu/descriptors.h"
#include "gpu/pass_timer.h"

namespace lightbench::gpu {

struct RecorderState {
    DeviceState& device;
    vk::raii::CommandPool pool;
    vk::raii::CommandBuffer commands;
    vk::raii::Fence fence;
    Descriptors descriptors;
    PassTimer timer;
    bool recording = false;
    explicit RecorderState(DeviceState& d);
};

// Begins the command buffer if need be, then the pass: its barriers before its clock, so that waiting is not counted as work.
void begin_pass(RecorderState& recorder, std::string_view name, PassUses& uses);
void end_pass(RecorderState& recorder);

} // namespace lightbench::gpu
