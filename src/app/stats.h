// What --stats tells of a run, as JSON. The keys are a contract with other people's scripts; what does not apply is null.
#pragma once

#include "gpu/device.h"
#include "plan/plan.h"
#include "render/render.h"

#include <chrono>
#include <optional>
#include <string>

namespace lightbench {

// Wall time since it was made, in milliseconds.
struct Stopwatch {
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    double milliseconds() const { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(); }
};

struct RunRecord {
    std::string scene; // as named on the command line
    std::optional<int> frame;
    bool counting = false;
    double load = 0, wall = 0, pipelines = 0; // milliseconds
    std::uint64_t device_peak = 0;            // bytes
    std::set<std::string> shaders{};          // entry points of which pipelines were made
};

std::string stats_json(const RunRecord& run, const Plan& plan, const gpu::DeviceInfo& device, const RenderOutput& output);

} // namespace lightbench
