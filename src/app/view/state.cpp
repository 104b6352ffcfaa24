#include "app/view/state.h"

#include "app/command_line.h"
#include "app/errors.h"
#include "app/numbers.h"
#include "app/view/camera.h"
#include "plan/complete.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace lightbench::view {
namespace {

constexpr const char *kModels[] = {"Phong", "Cook-Torrance"}, *kLaws[] = {"none", "linear", "inverse-square"},
                     *kStructures[] = {"none", "bvh", "sphere-bvh", "grid", "octree"},
                     *kShows[] = {"light", "patches", "form factors", "hemi-cube"}, *kMaps[] = {"wipe", "difference", "FLIP"};

// What an action leaves out; 0: it does something else.
std::uint32_t strip_of(Action action) {
    switch (action) {
    case Action::texture: return kWithoutTexture;
    case Action::bump: return kWithoutBump;
    case Action::environment: return kWithoutEnvironment;
    case Action::transparency: return kWithoutTransparency;
    case Action::reflection: return kWithoutReflection;
    default: return 0;
    }
}

// From "as the scene says" over each value back to it.
template <class T> void cycle(std::optional<T>& value, unsigned count) {
    const unsigned next = value ? static_cast<unsigned>(*value) + 1 : 0;
    value = next < count ? std::optional(static_cast<T>(next)) : std::nullopt;
}

template <class T> void cycle(T& value, unsigned count) {
    value = static_cast<T>((static_cast<unsigned>(value) + 1) % count);
}

unsigned stepped(unsigned value, int step, unsigned least, unsigned most) {
    return static_cast<unsigned>(std::clamp(static_cast<int>(value) + step, static_cast<int>(least), static_cast<int>(most)));
}

// Samples a pixel are squares.
unsigned stepped_samples(unsigned spp, int step) {
    const unsigned root = stepped(static_cast<unsigned>(std::lround(std::sqrt(double(spp)))), step, 1, 32);
    return root * root;
}

void apply_shading(Action action, Request& r) {
    switch (action) {
    case Action::raster: r.method = Method::raster; break;
    case Action::raytrace: r.method = Method::raytrace; break;
    case Action::radiosity: r.method = Method::radiosity; break;
    case Action::flat: r.shading = Shading::flat; break;
    case Action::gouraud: r.shading = Shading::gouraud; break;
    case Action::phong: r.shading = Shading::phong; break;
    case Action::model: cycle(r.model, 2); break;
    case Action::attenuation: cycle(r.attenuation, 3); break;
    default: break;
    }
}

void apply_detail(Action action, Request& r) {
    RadiosityParameters& radiosity = r.radiosity;
    switch (action) {
    case Action::subdivide_more: r.subdivide = stepped(r.subdivide, 1, 0, 8); break;
    case Action::subdivide_less: r.subdivide = stepped(r.subdivide, -1, 0, 8); break;
    case Action::samples_more: r.spp = stepped_samples(r.spp, 1); break;
    case Action::samples_less: r.spp = stepped_samples(r.spp, -1); break;
    case Action::depth_more: r.depth = stepped(r.depth, 1, 1, 255); break;
    case Action::depth_less: r.depth = stepped(r.depth, -1, 1, 255); break;
    case Action::structure: cycle(r.accel, 5), r.accel_parameters = {}; break;
    case Action::hemicube_more: radiosity.hemicube = std::min(2 * radiosity.hemicube, 1024u); break;
    case Action::hemicube_less: radiosity.hemicube = std::max(radiosity.hemicube / 4 * 2, 8u); break;
    case Action::show: cycle(radiosity.show, radiosity.pick ? 4 : 2); break;
    default: break;
    }
}

void apply_compare(Action action, State& s) {
    if (action == Action::split) {
        s.split = !s.split;
        if (s.split) s.sides[1] = s.sides[s.active], s.sides[0] = s.sides[1];
        if (!s.split) s.sides[0] = s.sides[s.active];
        s.active = s.split ? 1 : 0;
    }
    if (action == Action::side) s.active = 1 - s.active;
    if (action == Action::map) cycle(s.map, 3);
}

void apply_window(Action action, State& s, const Opened& opened, double aspect) {
    switch (action) {
    case Action::wireframe: s.wireframe = !s.wireframe; break;
    case Action::normals: s.normals = !s.normals; break;
    case Action::frame: frame(s.camera, opened.bounds, aspect); break;
    case Action::reset:
        s.camera = opened.camera, s.sides = {s.first, s.first}, s.sliders = s.first_sliders;
        s.split = s.wireframe = s.normals = false, s.active = 0, s.wipe = 0.5f, s.map = Map::wipe;
        break;
    case Action::panel: s.panel = !s.panel; break;
    case Action::help: s.help = !s.help; break;
    case Action::copy: s.copy = true; break;
    case Action::screenshot: s.screenshot = true; break;
    case Action::vsync: s.vsync = !s.vsync; break;
    case Action::quit: s.quit = true; break;
    default: break;
    }
}

std::string on_off(bool on) {
    return on ? "on" : "off";
}

template <class T> std::string as_file_or(const std::optional<T>& value, const char* const* names) {
    return value ? names[static_cast<std::size_t>(*value)] : "as the scene says";
}

} // namespace

Opened open_scene(std::filesystem::path file, Scene scene, const Request& request, std::uint64_t version) {
    Scene completed = scene;
    Request plain = request;
    plain.edits = {}, plain.model.reset(), plain.attenuation.reset();
    plain.method = Method::raster; // a headlight, where any method needs one
    CompleteResult result = complete(completed, plain);
    if (!result.completed) throw UserError(result.problems);
    Facts facts = gather_facts(completed);
    facts.headlight = result.completed->headlight;
    add_view(facts, completed, result.completed->view);
    const Bounds bounds = bounds_of(completed);
    return {std::move(file),
            std::make_shared<const Scene>(std::move(scene)),
            version,
            facts,
            bounds,
            result.completed->camera,
            result.completed->view.size};
}

State start(const Request& request, const Opened& opened) {
    State s;
    s.first = request, s.camera = opened.camera;
    s.first.size.reset(), s.first.frame.reset(), s.first.camera.clear(), s.first.placed.reset();
    if (request.size || request.crop) s.size = opened.size; // what a crop is of is not left to the window
    s.sides = {s.first, s.first};
    return s;
}

void apply(Action action, State& state, const Opened& opened, double aspect) {
    if (unavailable(action, state, opened)) return;
    state.side().edits.without ^= strip_of(action);
    apply_shading(action, state.side());
    apply_detail(action, state.side());
    apply_compare(action, state);
    apply_window(action, state, opened, aspect);
}

std::string setting_of(Action action, const State& s) {
    const Request& r = s.side();
    if (const std::uint32_t bit = strip_of(action)) return on_off(!(r.edits.without & bit));
    switch (action) {
    case Action::raster:
    case Action::raytrace:
    case Action::radiosity:
        return on_off(static_cast<unsigned>(r.method) == static_cast<unsigned>(action) - static_cast<unsigned>(Action::raster));
    case Action::flat:
    case Action::gouraud:
    case Action::phong:
        return on_off(static_cast<unsigned>(r.shading) == static_cast<unsigned>(action) - static_cast<unsigned>(Action::flat));
    case Action::model: return as_file_or(r.model, kModels);
    case Action::attenuation: return as_file_or(r.attenuation, kLaws);
    case Action::wireframe: return on_off(s.wireframe);
    case Action::normals: return on_off(s.normals);
    case Action::subdivide_more: return fmt::format("{}", r.subdivide);
    case Action::samples_more: return fmt::format("{}", r.spp);
    case Action::depth_more: return fmt::format("{}", r.depth);
    case Action::structure: return kStructures[static_cast<std::size_t>(r.accel)];
    case Action::hemicube_more: return fmt::format("{}", r.radiosity.hemicube);
    case Action::show: return kShows[static_cast<std::size_t>(r.radiosity.show)];
    case Action::split: return on_off(s.split);
    case Action::side: return s.active == 0 ? "A" : "B";
    case Action::map: return kMaps[static_cast<std::size_t>(s.map)];
    case Action::vsync: return on_off(s.vsync);
    default: return "";
    }
}

Request request_of(const State& state, unsigned side, glm::uvec2 size) {
    Request r = state.sides[side];
    r.size = size;
    // What is rendered is what the text of the camera says: the command line that is copied has no other.
    r.placed = parse_camera(text_of(state.camera));
    if (r.method != Method::raytrace && r.sampling == Sampling::adaptive) r.sampling = Sampling::none;
    if (r.sampling == Sampling::adaptive) r.spp = 1;
    if (r.method != Method::radiosity) r.radiosity = {};
    if (r.method != Method::raster || r.shading != Shading::phong) r.precision = Precision::float32;
    if (r.radiosity.pick && r.radiosity.show == Show::light) r.radiosity.pick.reset();
    return r;
}

} // namespace lightbench::view
