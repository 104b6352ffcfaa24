#include "plan/passes.h"

#include "plan/radiosity.h"

#include "shared/effects.h"
#include "shared/rays.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

using Names = std::vector<std::string>;

Names joined(Names a, const Names& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

bool contains(const Names& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// What drawing reads in each mode: colors that were shaded before, or all that shading a fragment needs.
// Textures are looked up there in every mode: what they modulate is shaded before, what they are is not.
Names drawn_from(const Plan& plan, const Names& lit_reads) {
    if (plan.shading == Shading::phong) return joined({"vertices", "normals", "indices"}, lit_reads);
    Names reads = {"vertices", "indices", plan.shading == Shading::flat ? "polygon-colors" : "vertex-colors"};
    if (plan.effects & (EFFECT_ANY_TEXTURE | EFFECT_TRANSPARENCY)) reads = joined(reads, {"normals", "materials"});
    if (plan.effects & EFFECT_TEXTURE) reads.emplace_back("texels");
    if (plan.effects & EFFECT_MAP_UV) reads.emplace_back("detail");
    return reads;
}

// A layer shades again with the mask of its one term, so that it reads what shading reads, not the colors of the image.
Names term_reads(Shading shading, const Names& lit_reads) {
    Names geometry = {"vertices", "indices"};
    if (shading == Shading::flat) geometry.push_back("polygons");
    if (shading != Shading::flat) geometry.push_back("normals");
    return joined(geometry, lit_reads);
}

std::string samples(const Plan& plan) {
    if (plan.multisamples > 1) return fmt::format(", {} samples a pixel", plan.multisamples);
    if (plan.frames > 1) return fmt::format(", once for each of {} shifted frames", plan.frames);
    return "";
}

bool is_filtered(const Plan& plan) {
    return plan.method == Method::raytrace && plan.filter == Filter::gaussian;
}

bool is_adaptive(const Plan& plan) {
    return plan.method == Method::raytrace && plan.sampling == Sampling::adaptive;
}

bool accumulates(const Plan& plan) {
    return !is_filtered(plan) && (plan.frames > 1 || plan.light_passes > 1);
}

// No image lies between the ray trees and what is shown.
bool one_frame_is_all(const Plan& plan) {
    return !is_adaptive(plan) && !is_filtered(plan) && !accumulates(plan);
}

std::string filter_reason(const Plan& plan) {
    return fmt::format("Gaussian, radius {:g}, sigma {:g}, of {}", plan.filter_width, plan.filter_sigma,
                       plan.frames == 1 ? "one sample a pixel"
                                        : fmt::format("{} frames, shifted {}", plan.frames, plan.jittered ? "at random" : "on a grid"));
}

std::string split_reason(const Plan& plan) {
    return fmt::format("in four at most {} time{}, where the contrast of their corners is above {:g}, {:g}, {:g}", plan.max_level,
                       plan.max_level == 1 ? "" : "s", plan.contrast.r, plan.contrast.g, plan.contrast.b);
}

// S26: the passes before and after the rays.
void add_lattice(std::vector<Pass>& passes, const Plan& plan) {
    if (!is_adaptive(plan)) return;
    if (plan.max_level > 0) passes.push_back({"split-cells", split_reason(plan), {"lattice"}, {"lattice-states"}});
    passes.push_back({"list-points", "corners of pixels and of what they were split into", {"lattice-states"}, {"lattice-points"}});
}

// What becomes of the roots of the ray trees.
void add_film(std::vector<Pass>& passes, const Plan& plan) {
    if (is_adaptive(plan)) {
        passes.push_back({"film", "their roots as points of the lattice", {"ray-tree", "lattice-points"}, {"lattice"}});
        passes.push_back({"lattice-pixels", "means of corners, by area", {"lattice", "lattice-states"}, {"radiance"}});
    } else if (is_filtered(plan)) {
        passes.push_back({"film", "their roots as samples, beside the crop too", {"ray-tree"}, {"samples"}});
        passes.push_back({"filter", filter_reason(plan), {"samples"}, {"sum"}});
    } else {
        passes.push_back({"film", "their roots as pixels", {"ray-tree"}, {"radiance"}});
    }
}

std::string sum_of(const Plan& plan) {
    if (plan.light_passes == 1) return fmt::format("mean of {} frames, shifted {}", plan.frames, plan.jittered ? "at random" : "on a grid");
    return fmt::format("sum of {} groups of at most {} lights, mean of {} frame{}", plan.light_passes, kLightsPerPass, plan.frames,
                       plan.frames == 1 ? "" : "s");
}

std::string display_reason(const Plan& plan) {
    return fmt::format("exposure {:g}, clamp", plan.exposure);
}

void add_background(std::vector<Pass>& passes, const Plan& plan) {
    if (plan.effects & EFFECT_BACKGROUND_MAP)
        passes.push_back({"background", "the environment, where nothing stands before it", {"texels", "depth"}, {"radiance"}});
}

// S13: counted, then listed where the counts say, then blended from the front to the back.
void add_layers(std::vector<Pass>& passes, const Plan& plan, const Names& lit_reads) {
    if (!(plan.effects & EFFECT_TRANSPARENCY)) return;
    passes.push_back({"count-layers", "translucent fragments of each pixel", {"vertices", "indices", "depth"}, {"layer-counts"}});
    Names reads = drawn_from(plan, lit_reads);
    reads.insert(reads.end(), {"depth", "layer-blocks", "layer-counts"});
    passes.push_back({"list-layers", "their color, opacity and depth", std::move(reads), {"layers", "layer-cursors"}});
    passes.push_back({"blend-layers",
                      "in order of depth, over what is opaque",
                      {"layers", "layer-blocks", "layer-counts", "layer-cursors", "radiance"},
                      {"radiance"}});
}

// Eye rays of pixels are made where they are traced.
void add_trace(std::vector<Pass>& passes, const Plan& plan) {
    const std::string each = "the nearest hit of each ray";
    if (is_adaptive(plan)) {
        passes.push_back({"eye-rays", "one a listed point", {"lattice-points"}, {"rays"}});
        passes.push_back({"trace", each, {"rays", "primitives", "structure"}, {"hits"}});
    } else {
        passes.push_back(
            {"trace", fmt::format("{}; eye rays one a pixel{}", each, samples(plan)), {"primitives", "structure"}, {"rays", "hits"}});
    }
}

// One generation of rays after the other; what a generation sends on is known when it has been shaded.
std::vector<Pass> ray_passes(const Plan& plan, const Names& lit_reads) {
    const bool smooth = plan.shading != Shading::flat;
    Names surfaces = joined({"rays", "hits", "primitives", "materials"}, lit_reads), sent = {"points"};
    if (smooth) surfaces.emplace_back("normals");
    if (plan.effects & EFFECT_BACKGROUND_MAP) surfaces.emplace_back("texels");
    if (plan.ray_effects & (RAY_REFLECTED | RAY_REFRACTED | RAY_STRAIGHT)) sent = joined(sent, {"rays", "ray-tree"});
    std::vector<Pass> passes;
    add_lattice(passes, plan);
    add_trace(passes, plan);
    passes.push_back({"shade", "surfaces that were hit, and the rays that they send on", surfaces, sent});
    Names lit = joined({"points", "rays"}, lit_reads);
    if (plan.ray_effects & RAY_SHADOWS) {
        passes.push_back({"shadow", "what stands before each light", {"points", "lights", "primitives", "structure"}, {"visibility"}});
        lit.emplace_back("visibility");
    }
    passes.push_back({"light", "the illumination model at those points", lit, {"ray-tree"}});
    if (plan.ray_effects & (RAY_REFLECTED | RAY_REFRACTED | RAY_STRAIGHT))
        passes.push_back({"gather", "the ray trees, from their leaves to their roots", {"ray-tree"}, {"ray-tree"}});
    add_film(passes, plan);
    if (accumulates(plan)) passes.push_back({"accumulate", sum_of(plan), {"radiance"}, {"sum"}});
    for (const std::string& term : plan.terms)
        passes.push_back({"term-" + term, "a layer of the file: rays once more, for this part", {"ray-tree"}, {"layer-" + term}});
    if (one_frame_is_all(plan))
        passes.push_back({"display", "their roots as pixels, " + display_reason(plan), {"ray-tree"}, {"pixels", "census"}});
    else
        passes.push_back({"display", display_reason(plan), {image_of(plan)}, {"pixels", "census"}});
    return passes;
}

// Each cube is a drawing of its own, with geometry and targets that are gone once its faces are read back.
void add_cubes(std::vector<Pass>& passes, const Plan& plan) {
    if (!(plan.effects & EFFECT_RENDERED_CUBE)) return;
    std::string sizes;
    for (const EnvironmentCube& cube : plan.cubes.cubes) sizes += fmt::format("{}{}", sizes.empty() ? "" : ", ", cube.size);
    const std::string sides = sizes.empty() ? "sized by the view" : fmt::format("{} pixels a side", sizes);
    passes.push_back({"environment-cube",
                      fmt::format("6 views from the middle of what mirrors, without it, {}; mirrors in them are drawn without what they "
                                  "mirror (one bounce)",
                                  sides),
                      {},
                      {"texels"}});
}

std::vector<Pass> raster_passes(const Plan& plan, const Names& lit_reads) {
    std::vector<Pass> passes;
    add_cubes(passes, plan);
    passes.push_back({"shade-polygons", "the model once a polygon, at its centre", joined({"polygons"}, lit_reads), {"polygon-colors"}});
    passes.push_back({"shade-vertices", "the model once a vertex", joined({"vertices", "normals"}, lit_reads), {"vertex-colors"}});
    Names targets;
    targets.emplace_back("radiance");
    targets.emplace_back("depth");
    if (plan.multisamples > 1) targets.emplace_back("radiance-samples");
    passes.push_back({"raster", "visible surfaces" + samples(plan), drawn_from(plan, lit_reads), targets});
    add_background(passes, plan);
    add_layers(passes, plan, lit_reads);
    if (accumulates(plan)) passes.push_back({"accumulate", sum_of(plan), {"radiance"}, {"sum"}});
    for (const std::string& term : plan.terms)
        passes.push_back({"term-" + term, "a layer of the file", term_reads(plan.shading, lit_reads), {"layer-" + term, "depth"}});
    passes.push_back({"display", display_reason(plan), {image_of(plan)}, {"pixels", "census"}});
    return passes;
}

} // namespace

std::string image_of(const Plan& plan) {
    return accumulates(plan) || is_filtered(plan) ? "sum" : "radiance";
}

std::vector<Pass> candidate_passes(const Plan& plan, const Names& lit_reads) {
    if (plan.method == Method::raytrace) return ray_passes(plan, lit_reads);
    if (plan.method == Method::raster) return raster_passes(plan, lit_reads);
    std::vector<Pass> passes = radiosity_passes(plan);
    if (accumulates(plan)) passes.push_back({"accumulate", sum_of(plan), {"radiance"}, {"sum"}});
    passes.push_back({"display", display_reason(plan), {image_of(plan)}, {"pixels", "census"}});
    return passes;
}

std::vector<Pass> walk_back(std::vector<Pass> candidates, Names wanted) {
    std::vector<Pass> kept;
    for (auto pass = candidates.rbegin(); pass != candidates.rend(); ++pass) {
        const bool needed =
            std::any_of(pass->writes.begin(), pass->writes.end(), [&](const std::string& w) { return contains(wanted, w); });
        if (!needed) continue;
        wanted.insert(wanted.end(), pass->reads.begin(), pass->reads.end());
        kept.push_back(std::move(*pass));
    }
    std::reverse(kept.begin(), kept.end());
    return kept;
}

} // namespace lightbench
