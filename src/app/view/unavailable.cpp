// Which actions would change nothing, and why: as the plan decides of the scene in the method that is shown.
#include "app/view/state.h"
#include "gpu/check.h"
#include "plan/fate.h"
#include "plan/radiosity.h"

#include <algorithm>

namespace lightbench::view {
namespace {

// The reason of the first, if none of the effects is drawn.
std::optional<std::string> none_drawn(const std::vector<std::string_view>& names, const Facts& facts, const Request& request) {
    std::optional<std::string> reason;
    for (const std::string_view name : names) {
        const auto effect = std::ranges::find(effects(), name, &Effect::name);
        CHECK(effect != effects().end(), "no effect is named {}", name);
        Decision decision = decide_effect(*effect, facts, request);
        if (decision.fate == Fate::drawn) return std::nullopt;
        if (!reason) reason = std::move(decision.reason);
    }
    return reason;
}

// As the plan has it: what it draws of the request.
Request drawn_of(const State& state, const Opened& opened) {
    Request r = state.side();
    r.method = method_for(opened.facts, r);
    return r;
}

std::optional<std::string> no_light_shown(const Request& r) {
    if (r.method != Method::radiosity || r.radiosity.show == Show::light) return std::nullopt;
    return "patches are shown, not their light";
}

std::optional<std::string> strip_unavailable(Action action, const Facts& facts, Request r) {
    if (auto reason = no_light_shown(r)) return reason;
    // A picture's mean color counts for radiosity, and whether a surface has a side behind what one sees through.
    if (action == Action::texture || action == Action::transparency) r.method = r.method == Method::raytrace ? r.method : Method::raster;
    switch (action) {
    case Action::texture: return none_drawn({"texture", "checker"}, facts, r);
    case Action::bump: return none_drawn({"bump: noise", "bump: waves", "bump: height image", "bump: normal map"}, facts, r);
    case Action::environment: return none_drawn({"environment: mirrored", "environment: background"}, facts, r);
    case Action::transparency: return none_drawn({"transparency", "transmission"}, facts, r);
    default: return none_drawn({"reflection", "environment: mirrored"}, facts, r); // kr weighs both
    }
}

// Rays find the normals of all but meshes and polygons with normals of their own on the shapes themselves.
std::optional<std::string> shading_unavailable(Action action, const Facts& facts, const Request& r) {
    if (r.method == Method::radiosity) return "radiosity interpolates what it solved";
    if (r.method == Method::raster) return std::nullopt;
    if (action == Action::gouraud) return "rays meet points, not vertices";
    return facts.mesh_objects == 0 && !facts.own_normals ? std::optional<std::string>("rays meet the shapes themselves") : std::nullopt;
}

std::optional<std::string> law_unavailable(Action action, const Facts& facts, const Request& r) {
    if (auto reason = no_light_shown(r)) return reason;
    if (action == Action::model) return none_drawn({"specular", "cook-torrance: gaussian", "cook-torrance: beckmann"}, facts, r);
    return none_drawn({"attenuation: none", "attenuation: linear", "attenuation: inverse-square"}, facts, r);
}

std::optional<std::string> detail_unavailable(Action action, const Facts& facts, const Request& r) {
    using Reason = std::optional<std::string>;
    const bool rays = r.method == Method::raytrace, radiosity = r.method == Method::radiosity;
    switch (action) {
    case Action::subdivide_more:
    case Action::subdivide_less:
        if (radiosity) return "radiosity cuts surfaces by itself";
        return rays && facts.mesh_objects + facts.polygons == 0 ? Reason("rays meet the shapes themselves") : std::nullopt;
    case Action::samples_more:
    case Action::samples_less:
        return rays && r.sampling == Sampling::adaptive ? Reason("adaptive sampling chooses their number") : std::nullopt;
    case Action::depth_more:
    case Action::depth_less:
        if (!rays) return "no rays are traced";
        return none_drawn({"transparency", "transmission", "reflection"}, facts, r) ? Reason("no ray is sent on") : std::nullopt;
    case Action::structure:
        if (radiosity) return "hemi-cubes have a structure of their own";
        return rays ? std::nullopt : Reason("no rays are traced");
    case Action::hemicube_more:
    case Action::hemicube_less:
        if (radiosity && r.radiosity.show == Show::patches) return "patches are shown, not their light";
        [[fallthrough]];
    default: return radiosity ? std::nullopt : Reason("belongs to radiosity");
    }
}

} // namespace

std::optional<std::string> unavailable(Action action, const State& state, const Opened& opened) {
    using Reason = std::optional<std::string>;
    const Request r = drawn_of(state, opened);
    switch (action) {
    case Action::texture:
    case Action::bump:
    case Action::environment:
    case Action::transparency:
    case Action::reflection: return strip_unavailable(action, opened.facts, r);
    case Action::radiosity:
        if (const Verdict verdict = radiosity_verdict(opened.facts, r.radiosity); !verdict.wanted) return verdict.reason;
        return std::nullopt;
    case Action::flat:
    case Action::gouraud:
    case Action::phong: return shading_unavailable(action, opened.facts, r);
    case Action::model:
    case Action::attenuation: return law_unavailable(action, opened.facts, r);
    case Action::subdivide_more:
    case Action::subdivide_less:
    case Action::samples_more:
    case Action::samples_less:
    case Action::depth_more:
    case Action::depth_less:
    case Action::structure:
    case Action::hemicube_more:
    case Action::hemicube_less:
    case Action::show: return detail_unavailable(action, opened.facts, r);
    case Action::wireframe:
    case Action::normals: return state.split && state.map != Map::wipe ? Reason("a map of differences has no lines") : std::nullopt;
    case Action::side:
    case Action::map: return state.split ? std::nullopt : Reason("there is one side");
    case Action::vsync: return state.screen_waits ? std::nullopt : Reason("a driver on the CPU copies into the window");
    default: return std::nullopt;
    }
}

} // namespace lightbench::view
