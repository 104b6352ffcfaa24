// The thread that renders. In: what is to be shown, the latest wish alone counts. Out: pictures as they become better, comparisons, ray trees.
// The window's thread never waits for it.
#pragma once

#include "app/view/stage.h"
#include "app/view/trial.h"
#include "image/compare.h"
#include "render/probe.h"

#include <array>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace lightbench::view {

// Shaders in place of the program's own, and the values of their sliders.
struct Swap {
    std::shared_ptr<const ShaderSet> set{}; // null: none
    gpu::Constants constants{};
    bool operator==(const Swap&) const = default;
};

struct Wish {
    SceneVersion scene{};
    std::vector<Request> sides{}; // one or two, with size and camera
    bool moving = false;          // the camera is: quick and coarse
    bool wireframe = false, normals = false;
    Swap shaders{};
    bool same_picture(const Wish& other) const {
        return scene.version == other.scene.version && sides == other.sides && moving == other.moving && wireframe == other.wireframe &&
               normals == other.normals && shaders == other.shaders;
    }
};

struct Question {
    SceneVersion scene{};
    Request request{};
    glm::uvec2 pixel{0};
};

// Of the two sides at rest.
struct Versus {
    double rmse = 0, flip = 0;
    std::shared_ptr<const Image8> difference, flip_map;
};

struct Answer {
    Question question{};
    std::optional<Probe> probe{};
    std::string problem{};
};

// What there is by now; pointers change when something is new.
struct News {
    std::array<std::shared_ptr<const Shot>, 2> shots{};
    std::shared_ptr<const Versus> versus{};
    std::shared_ptr<const Answer> answer{};
    std::string problem{};                               // of the wish; empty: none
    bool busy = false;                                   // something is not done yet
    std::string doing{};                                 // for people: "rendering"
    double progress = 0;                                 // share of the picture in work
    double pending_for = 0;                              // milliseconds since the wish in work was taken up
    std::uint64_t settled = 0;                           // wishes that were done to the end
    std::shared_ptr<const ShaderSet> shaders{};          // that drew the picture; null: the program's own
    std::shared_ptr<const std::set<std::string>> used{}; // entry points that the device has used
};

// Opened to render beside a window that shows: its threads, which of a driver on the CPU draw, give way to those of the window.
gpu::Device open_beside_window(const gpu::DeviceRequest& request);

class Worker {
  public:
    // `wake` is called from the worker's thread whenever there is news.
    Worker(gpu::Device device, std::function<void()> wake);
    ~Worker();
    void wish(Wish wish);
    void ask(Question question);
    News news() const;
    const gpu::DeviceInfo& device_info() const { return info_; }
    gpu::Device finish(); // stops; hands the device back

  private:
    void run();
    void take(const Wish& wish);
    void use_shaders(const Swap& shaders);
    void answer(const Question& question);
    bool shoot(const Wish& wish, unsigned side);
    void compare(const Wish& wish);
    bool superseded(const Wish& wish) const;
    void publish(const std::function<void(News&)>& change);

    gpu::DeviceInfo info_;
    std::optional<gpu::Device> device_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable something_;
    std::optional<Wish> next_;
    std::optional<Question> question_;
    News news_;
    std::chrono::steady_clock::time_point since_{};
    Swap shaders_;               // in the device
    std::optional<Stage> stage_; // of the worker's thread, as what follows
    bool stop_ = false;
    std::thread thread_; // the last: it uses all of the above
};

} // namespace lightbench::view
