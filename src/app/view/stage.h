// Renderers that are kept alive from picture to picture: the same path as `render`, so the same bytes, but a camera that moves or a setting
// that comes back costs no new pipelines, and a solved radiosity is solved once.
#pragma once

#include "app/prepare.h"
#include "render/render.h"

#include <list>
#include <memory>

namespace lightbench::view {

// A picture, and all that was decided and measured on the way to it.
struct Shot {
    Request request{};
    Plan plan{};
    View view{};
    std::shared_ptr<const Image8> pixels;
    std::shared_ptr<const Image8> marked; // the same with what is drawn over it; null: nothing
    RenderOutput output{};                // without pixels
    double milliseconds = 0;              // wall, of rendering alone
    bool whole = false;                   // nothing of it is left to be done
    bool coarse = false;                  // of a camera in motion: fewer pixels and samples than asked for
};

struct SceneVersion {
    std::shared_ptr<const Scene> scene;
    std::uint64_t version = 0;
};

// A renderer, and what it was made for.
struct Slot {
    std::uint64_t version = 0;
    Request request{};
    std::unique_ptr<Scene> scene{};       // completed
    std::unique_ptr<Prepared> prepared{}; // the renderer keeps a reference to its geometry
    std::optional<Renderer> renderer{};
    std::shared_ptr<const Shot> last{}; // whole
};

using Doing = std::function<void(const char*)>; // for people

class Stage {
  public:
    explicit Stage(gpu::Device& device) : device_(device) {}

    // Just as `render` does it. `doing` is told of a renderer that is made, and of its first picture. Throws what rendering throws.
    std::shared_ptr<Shot> render(const SceneVersion& scene, const Request& request, const RenderOptions& options, const Doing& doing);
    // For a camera in motion: the surfaces as they were cut for where it came from, and fewer pixels and samples if the last whole picture
    // took longer than a tenth of a second.
    std::shared_ptr<Shot> render_moving(const SceneVersion& scene, const Request& request, const Doing& doing);
    void clear() { slots_.clear(); }

  private:
    Slot* find(std::uint64_t version, const Request& request);
    Slot& prepare_slot(const SceneVersion& scene, const Request& request, const Doing& doing);
    gpu::Device& device_;
    std::list<Slot> slots_; // the last used first
    unsigned halvings_ = 1; // of a picture in motion
};

} // namespace lightbench::view
