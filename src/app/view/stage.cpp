#include "app/view/stage.h"

#include "app/errors.h"
#include "app/stats.h"

#include <cstring>

namespace lightbench::view {
namespace {

constexpr std::size_t kSlots = 5; // both sides at rest and in motion, and one to come back to
constexpr double kFluent = 100;   // milliseconds a picture
constexpr unsigned kMostHalvings = 4;

Request without_camera(Request request) {
    request.placed.reset();
    return request;
}

template <class T> bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same(const PointStreams& a, const PointStreams& b) {
    return same_bytes(a.positions, b.positions) && same_bytes(a.normals, b.normals) && same_bytes(a.detail, b.detail);
}

bool same(const RasterGeometry& a, const RasterGeometry& b) {
    return same(a.vertices, b.vertices) && same(a.polygons, b.polygons) && same_bytes(a.indices, b.indices) &&
           a.clusters.size() == b.clusters.size();
}

// Scene and settings are the same. What else a camera changes: how finely surfaces are cut (which radiosity does for itself), a headlight, views
// that mirrors show.
bool fits(const Slot& slot, const Scene& scene, const Prepared& next) {
    const Prepared& now = *slot.prepared;
    if (now.view.eye == next.view.eye && now.view.view_from_world == next.view.view_from_world) return true;
    if (!now.plan.cubes.of_object.empty() || !next.plan.cubes.of_object.empty()) return false;
    if (slot.scene->lights.size() != scene.lights.size() || now.plan.effects != next.plan.effects) return false;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (slot.scene->lights[i].direction != scene.lights[i].direction) return false;
    return now.plan.method == Method::radiosity || same(now.geometry, next.geometry);
}

std::shared_ptr<Shot> shot_of(Slot& slot, const Request& request, const View& view, const RenderOptions& options) {
    auto shot = std::make_shared<Shot>();
    const Stopwatch watch;
    shot->output = slot.renderer->render(view, options);
    shot->milliseconds = watch.milliseconds();
    shot->request = request, shot->plan = slot.prepared->plan, shot->view = view;
    if (shot->output.pixels) shot->pixels = std::make_shared<const Image8>(std::move(*shot->output.pixels));
    shot->output.pixels.reset();
    shot->whole = shot->output.done >= 1 && !shot->output.stopped;
    return shot;
}

// With fewer pixels and one sample each.
Request coarse(Request request, unsigned halvings) {
    if (!request.crop) request.size = glm::max(*request.size >> halvings, glm::uvec2(1));
    request.spp = 1, request.sampling = Sampling::none, request.filter = Filter::box;
    return request;
}

} // namespace

Slot* Stage::find(std::uint64_t version, const Request& request) {
    const Request key = without_camera(request);
    for (auto it = slots_.begin(); it != slots_.end(); ++it)
        if (it->version == version && it->request == key) {
            slots_.splice(slots_.begin(), slots_, it);
            return &slots_.front();
        }
    return nullptr;
}

Slot& Stage::prepare_slot(const SceneVersion& scene, const Request& request, const Doing& doing) {
    auto completed = std::make_unique<Scene>(*scene.scene);
    auto prepared = std::make_unique<Prepared>(prepare(*completed, request));
    Slot* slot = find(scene.version, request);
    if (slot != nullptr && slot->renderer && fits(*slot, *completed, *prepared)) {
        slot->prepared->view = prepared->view;
        return *slot;
    }
    doing("compiling: first use of this variant");
    if (slot == nullptr) {
        while (slots_.size() >= kSlots) slots_.pop_back();
        slots_.push_front({scene.version, without_camera(request)});
        slot = &slots_.front();
    }
    slot->renderer.reset();
    slot->scene = std::move(completed), slot->prepared = std::move(prepared);
    slot->renderer.emplace(device_, *slot->scene, slot->prepared->geometry, slot->prepared->plan);
    doing("rendering the first picture of this variant"); // in which a driver may compile still
    return *slot;
}

std::shared_ptr<Shot> Stage::render(const SceneVersion& scene, const Request& request, const RenderOptions& options, const Doing& doing) {
    const Slot* known = find(scene.version, request);
    if (known != nullptr && known->last && known->last->request == request) return std::make_shared<Shot>(*known->last);
    Slot& slot = prepare_slot(scene, request, doing);
    std::shared_ptr<Shot> shot = shot_of(slot, request, slot.prepared->view, options);
    if (shot->whole) slot.last = shot;
    return shot;
}

std::shared_ptr<Shot> Stage::render_moving(const SceneVersion& scene, const Request& request, const Doing& doing) {
    Slot* whole = find(scene.version, request);
    const bool radiosity = request.method == Method::radiosity;
    const bool fluent = whole != nullptr && whole->renderer && (radiosity || (whole->last && whole->last->milliseconds <= kFluent));
    const Request smaller = fluent ? request : coarse(request, halvings_);
    Slot* slot = fluent ? whole : find(scene.version, smaller);
    if (slot == nullptr || !slot->renderer) slot = &prepare_slot(scene, smaller, doing);
    const CompleteResult placed = complete(*slot->scene, smaller);
    if (!placed.completed) throw UserError(placed.problems);
    RenderOptions options;
    if (radiosity) options.stop = [] { return true; }; // as far as it is solved
    std::shared_ptr<Shot> shot = shot_of(*slot, request, placed.completed->view, options);
    shot->coarse = true, shot->whole = false;
    if (!fluent && shot->milliseconds > kFluent && halvings_ < kMostHalvings) ++halvings_;
    if (!fluent && shot->milliseconds < kFluent / 8 && halvings_ > 1) --halvings_;
    return shot;
}

} // namespace lightbench::view
