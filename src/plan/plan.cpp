// Decides: effects by their table, then the samples, then passes by walking back from the wanted image, then the resources they name.
#include "plan/plan.h"

#include "plan/effects.h"
#include "plan/fate.h"
#include "plan/passes.h"
#include "plan/radiosity.h"
#include "scene/distribution.h"
#include "shared/effects.h"
#include "shared/layouts.h"
#include "shared/rays.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace lightbench {
namespace {

// Sets the mask and the lines of what runs, what does not and what is drawn instead; returns what the wanted effects read.
std::vector<std::string> decide_effects(const Facts& facts, const Request& request, Plan& plan) {
    std::set<std::string> reads;
    for (const Effect& effect : effects()) {
        Decision decision = decide_effect(effect, facts, request);
        std::vector<Line>& lines = decision.fate == Fate::drawn      ? plan.wanted
                                   : decision.fate == Fate::replaced ? plan.fallbacks
                                                                     : plan.skipped;
        lines.push_back({std::string(effect.name), std::move(decision.reason)});
        if (decision.fate != Fate::drawn) continue;
        plan.effects |= effect.bit;
        if (request.method == Method::raytrace) plan.ray_effects |= effect.ray_bit;
        reads.insert(effect.reads.begin(), effect.reads.end());
    }
    return {reads.begin(), reads.end()};
}

void decide_lights(const Facts& facts, const Request& request, Plan& plan) {
    if (!is_lit(facts, request) || request.method == Method::radiosity) return;
    plan.light_count = facts.lights <= kFewLights ? static_cast<std::uint32_t>(facts.lights) : 0;
    if (request.method == Method::raster) plan.light_passes = (facts.lights + kLightsPerPass - 1) / kLightsPerPass;
}

// One frame of 1 or 4 hardware samples unless a pattern was named; every other number of samples is that many shifted frames.
void decide_samples(const Request& request, Plan& plan) {
    // Layers are listed one sample a pixel.
    const bool few = request.spp == 1 || (request.spp == 4 && !(plan.effects & EFFECT_TRANSPARENCY));
    const bool hardware = request.method != Method::raytrace && request.sampling == Sampling::none && few;
    plan.multisamples = hardware ? request.spp : 1;
    plan.frames = hardware ? 1 : request.spp;
    plan.jittered = request.sampling == Sampling::jittered;
}

// Double is of Phong's terms at each pixel; what is asked of others is said.
void decide_precision(const Request& request, Plan& plan) {
    if (request.precision == Precision::float32) return;
    const auto instead = [&](std::string reason) { plan.fallbacks.push_back({"precision", std::move(reason)}); };
    if (request.method != Method::raster || request.shading != Shading::phong)
        return instead("float32: float64 is what the rasteriser has for shading at each pixel");
    plan.precision = Precision::float64;
    if (plan.effects & EFFECT_COOK_TORRANCE) instead("float32 for the highlights of Cook and Torrance");
    if (plan.effects & EFFECT_TRANSPARENCY) instead("float32 for what one can see through");
}

void decide_cubes(const Facts& facts, Plan& plan) {
    if (!(plan.effects & EFFECT_RENDERED_CUBE) || !facts.cubes) return;
    plan.cubes = *facts.cubes;
    if (plan.cubes.objects <= kMostCubes) return;
    plan.fallbacks.push_back(
        {"environment: rendered", fmt::format("{} objects mirror: the {} nearest to the camera have cubes of their own, "
                                              "the others share the nearest of those",
                                              plan.cubes.objects, kMostCubes)});
}

// Layers: the terms that add up to the image, if they are not 0 everywhere, and what helps to understand it.
std::vector<std::string> decide_terms(const Facts& facts, const Request& request, std::uint32_t mask, std::uint32_t rays) {
    if (!request.terms || request.output != Output::radiance) return {};
    std::vector<std::string> terms;
    if (mask & EFFECT_AMBIENT) terms.push_back("ambient");
    if (mask & EFFECT_DIFFUSE) terms.push_back("diffuse");
    if (mask & (EFFECT_SPECULAR | EFFECT_COOK_TORRANCE)) terms.push_back("specular");
    if (mask & EFFECT_EMISSION) terms.push_back("emission");
    if (mask & EFFECT_MIRROR_ENVIRONMENT || rays & RAY_REFLECTED) terms.push_back("reflected");
    if (rays & (RAY_REFRACTED | RAY_STRAIGHT)) terms.push_back("refracted");
    if (facts.background || facts.environment_map) terms.push_back("background");
    if (rays & RAY_SHADOWS) terms.push_back("shadow");
    if (facts.lights > 0) terms.push_back("attenuation");
    terms.insert(terms.end(), {"normal", "depth", "object"});
    return terms;
}

void note_geometry(const Facts& facts, Plan& plan) {
    if (!facts.geometry) return;
    plan.triangles = facts.geometry->triangles;
    if (facts.geometry->dropped_degenerate == 0) return;
    plan.fallbacks.push_back({"polygons", fmt::format("{} without area: left out", facts.geometry->dropped_degenerate)});
}

void note_roughness(const Facts& facts, Plan& plan) {
    if (facts.smooth_lobes == 0) return;
    plan.fallbacks.push_back({"roughness", fmt::format("{} material{} below {:g}: drawn with that", facts.smooth_lobes,
                                                       facts.smooth_lobes == 1 ? "" : "s", kLeastRoughness)});
}

std::vector<std::string> wanted_images(const Plan& plan) {
    std::vector<std::string> wanted = {plan.output == Output::pixels ? "pixels" : image_of(plan)};
    for (const std::string& term : plan.terms) wanted.push_back("layer-" + term);
    return wanted;
}

// Targets have the whole image's size, whatever the crop; only what is handed out is cropped.
Resource target(std::string name, std::size_t bytes_per_pixel, std::string reason, const Plan& plan) {
    return {std::move(name), std::size_t{plan.size.x} * plan.size.y * bytes_per_pixel, std::move(reason)};
}

Resource table(std::string name, std::size_t count, std::size_t each) {
    return {std::move(name), count * each, fmt::format("{} of {} bytes", count, each)};
}

// Buffers sized by the tessellation: 0 bytes until it is known.
Resource geometry_buffer(const std::string& name, const Facts& facts, const Plan& plan) {
    if (!facts.geometry) return {name, 0, "sized by the tessellation"};
    if (name == "vertices") return table(name, facts.geometry->vertices, sizeof(gpu_layout::PointPosition));
    if (name == "detail") return table(name, facts.geometry->vertices, sizeof(gpu_layout::PointDetail));
    if (name == "normals") return table(name, facts.geometry->vertices, sizeof(gpu_layout::PointNormal));
    if (name == "indices") return table(name, 3 * facts.geometry->triangles, sizeof(std::uint32_t));
    if (name == "polygons")
        return table(name, facts.geometry->polygons, sizeof(gpu_layout::PointPosition) + sizeof(gpu_layout::PointNormal));
    if (name == "vertex-colors") return table(name, facts.geometry->vertices * plan.colors_of_point(), sizeof(glm::vec4));
    return table(name, facts.geometry->polygons * plan.colors_of_point(), sizeof(glm::vec4)); // polygon-colors
}

bool request_rays(const std::string& name) {
    static const std::set<std::string> names = {"primitives", "rays", "hits", "points", "visibility", "ray-tree", "media"};
    return names.contains(name);
}

// Who builds a tree of boxes, and why. Measured by tests/bench/build_bench.cpp.
std::string structure_reason(const Plan& plan) {
    if (plan.accel != Structure::bvh) return "sized by the scene's primitives";
    if (plan.accel_parameters.builder == TreeBuilder::device) return "bvh, built on the device as asked: sooner there, but slower to trace";
    return "bvh, built on the host: one by surface area is traced faster, and the scene is built once";
}

// Describes one resource by its name.
Resource describe(const std::string& name, const Facts& facts, const Plan& plan) {
    if (name == "structure") return {name, 0, structure_reason(plan)};
    if (name == "elements" || name == "form-factors" || name == "radiosity")
        return {name, 0, name == "form-factors" ? "a number an element, for each hemi-cube of a submission" : "sized by the elements"};
    if (request_rays(name)) return {name, 0, "sized by the scene's primitives and by the rays of a batch"};
    if (name == "lights") return table(name, facts.lights, sizeof(gpu_layout::Light));
    if (name == "materials") return table(name, facts.geometry ? facts.geometry->surfaces : 0, sizeof(gpu_layout::Material));
    if (name == "texels") {
        const std::string cubes = plan.runs("environment-cube") ? fmt::format(", and 6 of each of {} cubes", plan.cubes.cubes.size()) : "";
        return {name, 0, fmt::format("{} pictures{}, with their smaller levels", facts.pictures, cubes)};
    }
    if (name == "layer-counts" || name == "layer-cursors") return target(name, 4, "a number a pixel", plan);
    if (name == "layer-blocks") return target(name, 1, "16 bytes for 64 pixels", plan);
    if (name == "layers") return {name, 0, "16 bytes a translucent fragment, and its surface or opacity: sized by their count"};
    if (name == "depth") return target(name, 4 * plan.multisamples, "float, reversed", plan);
    if (name == "radiance-samples") return target(name, 16 * plan.multisamples, fmt::format("{} samples a pixel", plan.multisamples), plan);
    if (name == "samples") return {name, 0, "linear, 4 floats: the crop and a margin as wide as the filter"};
    if (name.starts_with("lattice")) return {name, 0, fmt::format("points 1/{} pixel apart, band by band", 1u << plan.max_level)};
    if (name == "radiance" || name == "sum" || name.starts_with("layer-")) return target(name, 16, "linear, 4 floats", plan);
    if (name == "pixels") return {name, std::size_t{plan.crop.size.x} * plan.crop.size.y * 4, "8 bit sRGB"};
    if (name == "census") return {name, sizeof(gpu_layout::Census), "counts pixels that are not finite"};
    return geometry_buffer(name, facts, plan);
}

std::vector<Resource> resources_of(const Facts& facts, const Plan& plan) {
    std::vector<Resource> resources;
    std::set<std::string> seen;
    const auto add = [&](const std::string& name) {
        if (seen.insert(name).second) resources.push_back(describe(name, facts, plan));
    };
    for (const Pass& pass : plan.passes) {
        std::for_each(pass.reads.begin(), pass.reads.end(), add);
        std::for_each(pass.writes.begin(), pass.writes.end(), add);
    }
    return resources;
}

} // namespace

bool Plan::runs(std::string_view pass) const {
    return std::any_of(passes.begin(), passes.end(), [&](const Pass& p) { return p.name == pass; });
}

bool Plan::has(std::string_view resource) const {
    return std::any_of(resources.begin(), resources.end(), [&](const Resource& r) { return r.name == resource; });
}

std::size_t Plan::colors_of_point() const {
    return (effects & EFFECT_TWO_SIDED ? 2u : 1u) * (effects & EFFECT_ANY_TEXTURE ? 2u : 1u);
}

std::vector<std::string> effect_names(const Plan& plan) {
    std::vector<std::string> names;
    for (const Effect& effect : effects())
        if ((effect.bit & plan.effects) || (effect.ray_bit & plan.ray_effects)) names.emplace_back(effect.name);
    return names;
}

Plan decide(const Facts& facts, const Request& asked, std::vector<Line> notes) {
    Request request = asked;
    request.method = method_for(facts, asked);
    if (request.method != asked.method)
        notes.push_back({"radiosity", fmt::format("{}: drawn by the rasteriser", radiosity_verdict(facts, asked.radiosity).reason)});
    Plan plan;
    plan.method = request.method, plan.shading = request.shading, plan.output = request.output;
    plan.size = request.size.value_or(plan.size);
    plan.crop = request.crop.value_or(Rect{glm::uvec2(0), plan.size});
    plan.depth = request.depth, plan.cutoff = request.cutoff, plan.accel = request.accel, plan.accel_parameters = request.accel_parameters;
    plan.filter = request.filter, plan.filter_width = request.filter_width, plan.filter_sigma = request.filter_sigma;
    plan.sampling = request.sampling, plan.contrast = request.contrast, plan.max_level = request.max_level;
    plan.exposure = request.exposure, plan.seed = request.seed, plan.subdivide = request.subdivide;
    plan.lights = facts.lights;
    plan.radiosity = request.radiosity;
    plan.fallbacks = std::move(notes);
    note_geometry(facts, plan);
    note_roughness(facts, plan);
    if (request.output == Output::radiance && request.exposure != 0)
        plan.fallbacks.push_back({"exposure", "not applied: a file of linear radiance has none"});
    if (request.method == Method::raytrace && request.shading == Shading::gouraud)
        plan.fallbacks.push_back({"shading", "gouraud: rays meet points, not vertices; normals are interpolated as with phong"});
    if (request.method != Method::raytrace && request.filter == Filter::gaussian)
        plan.fallbacks.push_back({"filter", "gaussian: the rasteriser's is a box, one pixel wide"});
    if (plan.method == Method::radiosity) note_radiosity(facts, plan);
    const std::vector<std::string> reads = decide_effects(facts, request, plan);
    decide_lights(facts, request, plan);
    decide_precision(request, plan);
    decide_cubes(facts, plan);
    decide_samples(request, plan);
    plan.terms = decide_terms(facts, request, plan.effects, plan.ray_effects);
    plan.passes = walk_back(candidate_passes(plan, reads), wanted_images(plan));
    plan.resources = resources_of(facts, plan);
    return plan;
}

} // namespace lightbench
