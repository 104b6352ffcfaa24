#include "app/view/state.h"

#include "app/command_line.h"
#include "app/errors.h"
#include "app/numbers.h"
#include "app/view/camera.h"
#include "plan/complete.h"
#include "plan/effects.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace lightbench::view {
namespace {

constexpr const char *kModels[] = {"Phong", "Cook-Torrance"}, *kLaws[] = {"none", "linear", "inverse-square"},
                     *kStructures[] = {"none", "bvh", "sphere-bvh", "grid", "octree"},
                     *kShows[] = {"light", "patches", "form factors", "hemi-cube"}, *kMaps[] = {"wipe", "difference", "FLIP"};

struct StripRow {
    Action action;
    std::uint32_t bit;
    std::vector<std::string_view> effects; // of the plan; one of them wanted: there is something to leave out
};

const std::vector<StripRow>& strips() {
    static const std::vector<StripRow> rows = {
        {Action::texture, kWithoutTexture, {"texture", "checker"}},
        {Action::bump, kWithoutBump, {"bump: noise", "bump: waves", "bump: height image", "bump: normal map"}},
        {Action::environment, kWithoutEnvironment, {"environment: mirrored", "environment: background"}},
        {Action::transparency, kWithoutTransparency, {"transparency", "transmission"}},
        {Action::reflection, kWithoutReflection, {"reflection"}},
    };
    return rows;
}

const StripRow* strip_of(Action action) {
    const auto row = std::ranges::find(strips(), action, &StripRow::action);
    return row == strips().end() ? nullptr : &*row;
}

// The first reason, if none of the effects is wanted.
std::optional<std::string> none_wanted(const std::vector<std::string_view>& names, const Facts& facts, const Request& request) {
    std::optional<std::string> reason;
    for (const Effect& effect : effects()) {
        if (std::ranges::find(names, effect.name) == names.end()) continue;
        const Verdict verdict = effect.wanted(facts, request);
        if (verdict.wanted) return std::nullopt;
        if (!reason) reason = verdict.reason;
    }
    return reason;
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

std::optional<std::string> unavailable(Action action, const State& state, const Opened& opened) {
    const Request& r = state.side();
    if (const StripRow* row = strip_of(action)) return none_wanted(row->effects, opened.facts, r);
    const bool rays = r.method == Method::raytrace, radiosity = r.method == Method::radiosity;
    switch (action) {
    case Action::flat:
    case Action::gouraud:
    case Action::phong:
        if (radiosity) return "radiosity interpolates what it solved";
        if (rays && action == Action::gouraud) return "rays meet points, not vertices";
        return std::nullopt;
    case Action::model: return none_wanted({"specular", "cook-torrance: gaussian", "cook-torrance: beckmann"}, opened.facts, r);
    case Action::attenuation:
        return none_wanted({"attenuation: none", "attenuation: linear", "attenuation: inverse-square"}, opened.facts, r);
    case Action::depth_more:
    case Action::depth_less:
    case Action::structure: return rays ? std::nullopt : std::optional<std::string>("no rays are traced");
    case Action::hemicube_more:
    case Action::hemicube_less:
    case Action::show: return radiosity ? std::nullopt : std::optional<std::string>("belongs to radiosity");
    case Action::side:
    case Action::map: return state.split ? std::nullopt : std::optional<std::string>("there is one side");
    default: return std::nullopt;
    }
}

void apply(Action action, State& state, const Opened& opened, double aspect) {
    if (unavailable(action, state, opened)) return;
    if (const StripRow* row = strip_of(action)) state.side().edits.without ^= row->bit;
    apply_shading(action, state.side());
    apply_detail(action, state.side());
    apply_compare(action, state);
    apply_window(action, state, opened, aspect);
}

std::string setting_of(Action action, const State& s) {
    const Request& r = s.side();
    if (const StripRow* row = strip_of(action)) return on_off(!(r.edits.without & row->bit));
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
    if (r.method != Method::radiosity) r.radiosity = {};
    if (r.radiosity.pick && r.radiosity.show == Show::light) r.radiosity.pick.reset();
    return r;
}

} // namespace lightbench::view
