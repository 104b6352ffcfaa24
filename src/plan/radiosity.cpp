#include "plan/radiosity.h"

#include "shared/effects.h"

#include <fmt/format.h>
#include <set>

namespace lightbench {
namespace {

// Lights without area feed the surfaces once, before the first shot. Beside a lamp that glows they are mostly its stand-ins for methods that
// know no other lights.
bool is_fed(const Facts& facts, const RadiosityParameters& p) {
    return facts.lights > 0 && !facts.headlight && (p.feed || facts.emissive_materials == 0);
}

std::string shots_reason(const RadiosityParameters& p) {
    const std::string most = p.shots ? fmt::format(", or {} shots", *p.shots) : "";
    return fmt::format("progressive refinement, the largest unshot energy first, until {:g} of the light is unshot{}", p.until, most);
}

std::string form_factor_reason(const RadiosityParameters& p) {
    return fmt::format("form factors, {0}x{0} pixels a face{1}", p.hemicube,
                       p.correct_near ? "; near surfaces by analytic form factors and traced visibility" : "");
}

} // namespace

Verdict radiosity_verdict(const Facts& f, const RadiosityParameters& p) {
    if (f.diffuse_materials == 0) return {false, "no material has kd > 0: no surface sends light on"};
    if (f.emissive_materials == 0 && !is_fed(f, p)) return {false, "no material glows and there is no light"};
    if (f.emissive_materials == 0) return {true, fmt::format("{} light{} feed diffuse surfaces", f.lights, f.lights == 1 ? "" : "s")};
    return {true, fmt::format("{} of {} materials glow{}", f.emissive_materials, f.materials, f.emissive_materials == 1 ? "s" : "")};
}

std::string left_out_by_radiosity(std::string_view effect, const Facts& facts, const RadiosityParameters& p) {
    static const std::set<std::string_view> known = {"emission", "diffuse", "many-materials", "environment: background",
                                                     "environment: six faces"};
    static const std::set<std::string_view> of_lights = {"point light",       "directional light",   "spot light",
                                                         "attenuation: none", "attenuation: linear", "attenuation: inverse-square"};
    if (known.contains(effect)) return "";
    if (of_lights.contains(effect))
        return is_fed(facts, p)  ? ""
               : facts.headlight ? "a headlight feeds nothing"
                                 : "surfaces glow, which light without area may stand in for; --feed-lights adds it";
    if (effect == "texture" || effect == "checker") return "radiosity: surfaces send the mean color of their picture";
    if (effect == "ambient") return "radiosity finds it out by itself";
    if (effect == "two-sided") return "radiosity: both sides have elements of their own";
    return "radiosity: surfaces are opaque and diffuse";
}

namespace {

// Of what is shown in place of the light.
std::vector<Pass> passes_of_show(const RadiosityParameters& p) {
    if (p.show == Show::patches) return {{"raster", "elements, each patch in a color of its own", {"elements"}, {"radiance", "depth"}}};
    const Pass cube{"hemi-cube", form_factor_reason(p), {"elements", "structure"}, {"form-factors"}};
    if (p.show == Show::hemicube)
        return {cube, {"unfold", "what the five faces see, patches in their colors", {"elements", "form-factors"}, {"radiance"}}};
    return {cube, {"raster", "elements, by what they get of the picked patch", {"elements", "form-factors"}, {"radiance", "depth"}}};
}

} // namespace

std::vector<Pass> radiosity_passes(const Plan& plan) {
    const RadiosityParameters& p = plan.radiosity;
    if (p.show != Show::light) return passes_of_show(p);
    std::vector<Pass> passes;
    if (plan.effects & (EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT))
        passes.push_back({"feed", "lights without area, once, before the first shot", {"elements", "structure", "lights"}, {"radiosity"}});
    passes.push_back({"hemi-cube", form_factor_reason(p), {"elements", "structure"}, {"form-factors"}});
    if (p.solver == Solver::full)
        passes.push_back({"gauss-seidel", "the full matrix, until nothing changes", {"elements", "form-factors"}, {"radiosity"}});
    else
        passes.push_back({"shots", shots_reason(p), {"elements", "form-factors", "radiosity"}, {"radiosity"}});
    passes.push_back({"raster",
                      fmt::format("elements, by values at their corners{}", p.ambient ? ", with what is unshot as ambient light" : ""),
                      {"elements", "radiosity"},
                      {"radiance", "depth"}});
    if (plan.effects & EFFECT_BACKGROUND_MAP)
        passes.push_back({"background", "the environment, where nothing stands before it", {"texels", "depth"}, {"radiance"}});
    return passes;
}

void note_radiosity(const Facts& facts, Plan& plan) {
    RadiosityParameters& p = plan.radiosity;
    if (facts.white_materials > 0)
        plan.fallbacks.push_back(
            {"reflectance", fmt::format("{} material{} with kd above {:g}: sent on with that, or light would never end",
                                        facts.white_materials, facts.white_materials == 1 ? "" : "s", kMostReflectance)});
    if (p.solver != Solver::full) return;
    if (p.shots) plan.fallbacks.push_back({"shots", "the full matrix has none: --shots is left out"});
    p.shots.reset(), p.ambient = false;
}

} // namespace lightbench
