// The first frame of somebody's shaders, drawn small by this program in a child process: what hangs or crashes there leaves the viewer alone.
#pragma once

#include "app/live_shaders.h"
#include "plan/request.h"

#include <memory>

namespace lightbench::view {

// What takes the place of the program's own.
struct ShaderSet {
    ShaderModules modules{};
    std::vector<Slider> sliders{};
};

struct Trial {
    std::filesystem::path scene{};
    std::vector<std::string> options{}; // that a request does not hold: the device
    Request request{};
    std::map<std::string, float> sliders{};
};

// The second is for methods that are not shown, whose structures and pipelines are all made anew.
constexpr std::chrono::seconds kTrialLimit(5), kOtherTrialLimit(15);

// Why these cannot be used; empty: they drew a picture. `method` takes the place of the trial's own.
std::string try_shaders(const Trial& trial, Method method, const ShaderModules& modules, const gpu::Constants& constants);

} // namespace lightbench::view
