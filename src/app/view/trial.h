// The first frame of somebody's shaders, drawn small by this program in a child process: what hangs or crashes there leaves the viewer alone.
#pragma once

#include "app/live_shaders.h"
#include "image/child_process.h"
#include "image/temporary_folder.h"
#include "plan/request.h"

#include <functional>
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
    std::vector<Request> requests{};    // of what is shown: one, or both sides
    std::map<std::string, float> sliders{};
    bool operator==(const Trial&) const = default;
};

// Trials of one key run the same shaders: cameras and sizes are left out.
std::string key_of(const Trial& trial);

// The second is for rays and radiosity, which make many pipelines.
constexpr std::chrono::seconds kTrialLimit(5), kLongTrialLimit(15);
constexpr double kMostSeconds = 30; // of a picture that cannot be given up half-way

struct Tried {
    std::string problem{};        // why these cannot be used; empty: they drew the pictures
    std::set<std::string> used{}; // entry points that they used
    bool stopped = false;         // because `stop` was true
};

// Children that open their device and prepare the pictures while the shaders are still being compiled. They end when this goes away.
class TrialRun {
  public:
    explicit TrialRun(Trial trial);
    // Once.
    Tried finish(const ShaderModules& modules, const gpu::Constants& constants, const std::function<bool()>& stop);
    const Trial& trial() const { return trial_; }

  private:
    Trial trial_;
    TemporaryFolder folder_;
    struct Picture {
        Request request;
        Child child;
    };
    std::vector<Picture> pictures_;
};

} // namespace lightbench::view
