#include "plan/effects.h"

#include "shared/effects.h"
#include "shared/rays.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

template <class... Args> Verdict yes(fmt::format_string<Args...> text, Args&&... args) {
    return {true, fmt::format(text, std::forward<Args>(args)...)};
}
template <class... Args> Verdict no(fmt::format_string<Args...> text, Args&&... args) {
    return {false, fmt::format(text, std::forward<Args>(args)...)};
}

std::string counted(std::size_t n, std::string_view noun) {
    return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

// "3 of 5 materials have ks > 0", in the singular where it must be.
std::string share(std::size_t n, std::size_t of, std::string_view what) {
    if (of == 1) return fmt::format("the material has {}", what);
    return fmt::format("{} of {} materials {} {}", n, of, n == 1 ? "has" : "have", what);
}

Verdict ambient(const Facts& f, const Request&) {
    if (!f.ambient) return no("the ambient light is 0");
    if (f.diffuse_materials == 0) return no("no material has kd > 0");
    return yes("{}", share(f.diffuse_materials, f.materials, "kd > 0"));
}

Verdict diffuse(const Facts& f, const Request&) {
    if (f.lights == 0) return no("there is no light");
    if (f.diffuse_materials == 0) return no("no material has kd > 0");
    return yes("{}", share(f.diffuse_materials, f.materials, "kd > 0"));
}

Verdict specular(const Facts& f, const Request&) {
    if (f.lights == 0) return no("there is no light");
    if (f.specular_materials == 0) return no("no material has ks > 0");
    if (f.phong_materials == 0) return no("highlights are all by Cook and Torrance");
    return yes("{}", share(f.phong_materials, f.materials, "ks > 0"));
}

Verdict of_distribution(const Facts& f, std::size_t n, std::string_view name) {
    if (n == 0) return no("no material uses it");
    if (f.lights == 0) return no("there is no light");
    return yes("{}", share(n, f.materials, name));
}

Verdict gaussian(const Facts& f, const Request&) {
    return of_distribution(f, f.gaussian_materials, "ks > 0 and this distribution");
}
Verdict beckmann(const Facts& f, const Request&) {
    return of_distribution(f, f.beckmann_materials, "ks > 0 and this distribution");
}

Verdict emission(const Facts& f, const Request&) {
    if (f.emissive_materials == 0) return no("no material glows");
    return yes("{}", share(f.emissive_materials, f.materials, "an emission"));
}

// A property of `n` lights: without effect where nothing answers to light.
Verdict of_lights(const Facts& f, const Request& r, std::size_t n, std::string_view none) {
    if (n == 0) return no("{}", none);
    if (!is_lit(f, r)) return no("{}, but no material has kd > 0 or ks > 0", counted(n, "light"));
    return yes("{}", counted(n, "light"));
}

Verdict point(const Facts& f, const Request& r) {
    return of_lights(f, r, f.point_lights, "no point light");
}
Verdict directional(const Facts& f, const Request& r) {
    return of_lights(f, r, f.directional_lights, "no directional light");
}
Verdict spot(const Facts& f, const Request& r) {
    return of_lights(f, r, f.spot_lights, "no spot light");
}

// Directional lights are never attenuated, so that a scene of those alone has no law at all.
Verdict of_law(const Facts& f, const Request& r, std::size_t n) {
    if (f.point_lights + f.spot_lights == 0) return no("no light has a distance");
    return of_lights(f, r, n, "no light uses it");
}

Verdict law_none(const Facts& f, const Request& r) {
    return of_law(f, r, f.unattenuated_lights);
}
Verdict law_linear(const Facts& f, const Request& r) {
    return of_law(f, r, f.linear_lights);
}
Verdict law_inverse_square(const Facts& f, const Request& r) {
    return of_law(f, r, f.inverse_square_lights);
}

Verdict two_sided(const Facts& f, const Request& r) {
    if (f.two_sided_objects == 0 || (f.geometry && f.geometry->faces_two_sided == 0)) return no("no surface is seen from behind");
    if (!is_lit(f, r)) return no("no light tells the two sides apart");
    return yes("{} of {} may be seen from behind", f.two_sided_objects, counted(f.objects, "object"));
}

// Interpolated normals exist with Phong only. The files' own normals may point anywhere; computed ones lie about their faces' normals.
Verdict vanishing_normals(const Facts& f, const Request& r) {
    if (r.shading != Shading::phong) return no("normals are not interpolated");
    if (!is_lit(f, r)) return no("no term reads normals");
    if (!f.own_normals) return no("all normals are computed");
    if (f.geometry && !f.geometry->normals_may_vanish) return no("the file's normals agree with the faces");
    return yes("{}", f.geometry ? "the file's normals may cancel inside of a triangle" : "the file has normals of its own");
}

// A plain float sum of n terms errs by at most (n - 1) u; LI-6 asks for 8 u.
Verdict compensated_sum(const Facts& f, const Request& r) {
    if (!is_lit(f, r)) return no("no light is summed");
    if (f.lights <= 9) return no("{}: a plain sum errs by at most 8 u", counted(f.lights, "light"));
    return yes("{}: a plain sum could err by more than 8 u", counted(f.lights, "light"));
}

Verdict of_materials(std::size_t n, std::string_view none) {
    return n > 0 ? yes("{}", counted(n, "material")) : no("{}", none);
}

// kd is what a texture modulates.
Verdict of_texture(const Facts& f, const Request& r, std::size_t n, std::string_view none) {
    if (n == 0) return no("{}", none);
    const bool alpha = n == f.picture_materials && f.alpha_materials > 0;
    if (!ambient(f, r).wanted && !diffuse(f, r).wanted && !alpha) return no("{}, but nothing shows its kd", counted(n, "material"));
    return yes("{}", counted(n, "material"));
}

Verdict texture(const Facts& f, const Request& r) {
    return of_texture(f, r, f.picture_materials, "no material has a picture");
}
Verdict checker(const Facts& f, const Request& r) {
    return of_texture(f, r, f.checker_materials, "no material has one");
}

Verdict texture_alpha(const Facts& f, const Request&) {
    return of_materials(f.alpha_materials, "no picture's alpha is opacity");
}

Verdict of_bump(const Facts& f, const Request& r, std::size_t n) {
    if (n == 0) return no("no material has one");
    if (!is_lit(f, r) && f.environment_materials == 0) return no("{}, but no term reads normals", counted(n, "material"));
    return yes("{}", counted(n, "material"));
}

Verdict bump_waves(const Facts& f, const Request& r) {
    return of_bump(f, r, f.wave_materials);
}
Verdict bump_noise(const Facts& f, const Request& r) {
    return of_bump(f, r, f.noise_materials);
}
Verdict bump_height(const Facts& f, const Request& r) {
    return of_bump(f, r, f.height_materials);
}
Verdict normal_map(const Facts& f, const Request& r) {
    return of_bump(f, r, f.normal_map_materials);
}

Verdict of_mapping(const Facts& f, const Request& r, Mapping mapping) {
    const std::size_t n = f.mappings[static_cast<std::size_t>(mapping)];
    if (n == 0) return no("nothing is mapped so");
    if (!texture(f, r).wanted && !checker(f, r).wanted && !bump_height(f, r).wanted && !normal_map(f, r).wanted)
        return no("nothing that is mapped is drawn");
    return yes("{}", counted(n, "object"));
}

Verdict map_uv(const Facts& f, const Request& r) {
    return of_mapping(f, r, Mapping::uv);
}
Verdict map_spherical(const Facts& f, const Request& r) {
    return of_mapping(f, r, Mapping::spherical);
}
Verdict map_cylindrical(const Facts& f, const Request& r) {
    return of_mapping(f, r, Mapping::cylindrical);
}
Verdict map_planar(const Facts& f, const Request& r) {
    return of_mapping(f, r, Mapping::planar);
}

bool traces(const Request& r) {
    return r.method == Method::raytrace;
}

// Without a map the rasteriser mirrors what it renders itself; rays find the scene where they go.
Verdict rendered_environment(const Facts& f, const Request& r) {
    if (f.environment_materials == 0) return no("no material mirrors it");
    if (f.environment_map) return no("the scene has a map");
    if (traces(r)) return no("rays meet the scene itself where kr > 0");
    if (!f.cubes) return yes("the scene has no map: {} mirror it", counted(f.environment_materials, "material"));
    if (f.cubes->objects == 0) return no("nothing that mirrors it has an extent");
    return yes("the scene has no map: {} mirror{} it", counted(f.cubes->objects, "object"), f.cubes->objects == 1 ? "s" : "");
}

Verdict mirror_environment(const Facts& f, const Request& r) {
    if (f.environment_materials == 0) return no("no material mirrors it");
    if (!f.environment_map && !rendered_environment(f, r).wanted)
        return no("{}, but the scene has no map", counted(f.environment_materials, "material"));
    return yes("{}", share(f.environment_materials, f.materials, "a weight of the environment"));
}

Verdict many_materials(const Facts& f, const Request& r) {
    const bool read = ambient(f, r).wanted || diffuse(f, r).wanted || specular(f, r).wanted || emission(f, r).wanted ||
                      gaussian(f, r).wanted || beckmann(f, r).wanted || mirror_environment(f, r).wanted || f.translucent_materials > 0 ||
                      (r.method == Method::raytrace && f.reflective_materials + f.transmissive_materials > 0);
    if (!read) return no("no property of a material changes the image");
    const bool detailed =
        f.picture_materials + f.checker_materials + f.wave_materials + f.noise_materials + f.height_materials + f.normal_map_materials >
            0 ||
        rendered_environment(f, r).wanted;
    const std::size_t most = f.geometry ? f.geometry->surfaces : detailed ? f.objects : f.materials;
    if (f.materials == 1 && most <= 1) return no("every surface has the same material");
    if (f.materials == 1) return yes("one material, laid on {} in their own ways", counted(most, "object"));
    return yes("{}", counted(f.materials, "material"));
}

Verdict background_map(const Facts& f, const Request&) {
    return f.environment_map ? yes("the scene has a map") : no("the scene has no map");
}

Verdict six_faces(const Facts& f, const Request& r) {
    if (rendered_environment(f, r).wanted) return yes("what is rendered is six views");
    if (!f.environment_map) return no("the scene has no map");
    return f.six_faces ? yes("the map is six pictures") : no("the map is one picture");
}

// Where nothing is refracted, what would be goes straight through.
Verdict transparency(const Facts& f, const Request& r) {
    if (traces(r) && f.clear_materials == 0 && f.one_sided_materials > 0)
        return yes("{} with two_sided = false: rays pass the backs", counted(f.one_sided_materials, "material"));
    return of_materials(traces(r) ? f.clear_materials : f.translucent_materials, "every opacity is 1");
}
bool reflects(const Facts& f) {
    return f.reflective_materials > 0;
}

Verdict transmission(const Facts& f, const Request&) {
    return of_materials(f.transmissive_materials, "every kt is 0");
}
Verdict fresnel(const Facts& f, const Request&) {
    return of_materials(f.fresnel_materials, "no material asks for it");
}
Verdict scatter(const Facts& f, const Request& r) {
    if (traces(r) && f.scattering_materials > 0 && f.transmissive_materials == 0 && !reflects(f))
        return no("{}, but none reflects or transmits", counted(f.scattering_materials, "material"));
    return of_materials(f.scattering_materials, "no surface is frosted");
}
Verdict dispersion(const Facts& f, const Request&) {
    return of_materials(std::max(f.dispersive_materials, f.tinted_materials), "no material asks for it");
}

Verdict shadows(const Facts& f, const Request& r) {
    if (!traces(r)) return no("the rasteriser casts none");
    if (!is_lit(f, r)) return no("nothing is lit");
    return yes("{}", counted(f.lights, "light"));
}

Verdict clear_shadows(const Facts& f, const Request& r) {
    if (!traces(r) || !shadows(f, r).wanted) return no("there are no shadows");
    const std::size_t n = std::max(f.clear_materials, f.transmissive_materials);
    if (n == 0) return no("nothing lets light through");
    if (r.opaque_shadows) return no("{}, but --opaque-shadows was asked for", counted(n, "material"));
    return yes("{}", counted(n, "material"));
}

Verdict cutoff(const Facts& f, const Request& r) {
    if (!traces(r)) return no("no rays are traced");
    if (r.cutoff <= 0) return no("--cutoff is 0");
    if (!reflects(f) && f.transmissive_materials + f.clear_materials + f.one_sided_materials == 0) return no("no ray is sent on");
    return yes("rays of a weight below {:g} are not sent", r.cutoff);
}

Verdict counters(const Facts&, const Request& r) {
    if (!traces(r)) return no("no rays are traced");
    return r.count ? yes("--count was asked for") : no("--count was not asked for");
}

Verdict reflection(const Facts& f, const Request& r) {
    if (traces(r) && f.reflective_materials == 0 && f.transmissive_materials > 0)
        return yes("every kr is 0, but {} transmit and reflect beyond the critical angle", counted(f.transmissive_materials, "material"));
    if (traces(r)) return of_materials(f.reflective_materials, "every kr is 0");
    if (f.mirror_materials > 0) return yes("{}", counted(f.mirror_materials, "mirror"));
    if (f.reflective_materials > 0) return no("no material names one (kr = ks counts where rays are traced)");
    return no("every kr is 0");
}

const std::vector<Effect>& table() {
    using R = std::vector<std::string_view>;
    const R surface = {"materials"}, pictures = {"materials", "texels"}, lit = {"materials", "lights"}, light = {"lights"};
    static const std::vector<Effect> rows = {
        {"ambient", EFFECT_AMBIENT, ambient, surface, ""},
        {"diffuse", EFFECT_DIFFUSE, diffuse, lit, ""},
        {"specular", EFFECT_SPECULAR, specular, lit, ""},
        {"emission", EFFECT_EMISSION, emission, surface, ""},
        {"point light", EFFECT_POINT_LIGHT, point, light, ""},
        {"directional light", EFFECT_DIRECTIONAL_LIGHT, directional, light, ""},
        {"spot light", EFFECT_SPOT_LIGHT, spot, light, ""},
        {"attenuation: none", EFFECT_ATTENUATION_NONE, law_none, light, ""},
        {"attenuation: linear", EFFECT_ATTENUATION_LINEAR, law_linear, light, ""},
        {"attenuation: inverse-square", EFFECT_ATTENUATION_INVERSE_SQUARE, law_inverse_square, light, ""},
        {"two-sided", EFFECT_TWO_SIDED, two_sided, {}, ""},
        {"vanishing-normals", EFFECT_VANISHING_NORMALS, vanishing_normals, {}, ""},
        {"many-materials", EFFECT_MANY_MATERIALS, many_materials, surface, ""},
        {"compensated-sum", EFFECT_COMPENSATED_SUM, compensated_sum, {}, ""},
        {"cook-torrance: gaussian", EFFECT_GAUSSIAN, gaussian, lit, ""},
        {"cook-torrance: beckmann", EFFECT_BECKMANN, beckmann, lit, ""},
        {"texture", EFFECT_TEXTURE, texture, pictures, ""},
        {"texture: alpha", EFFECT_TEXTURE_ALPHA, texture_alpha, pictures, ""},
        {"checker", EFFECT_CHECKER, checker, surface, ""},
        {"mapping: uv", EFFECT_MAP_UV, map_uv, {"detail"}, ""},
        {"mapping: spherical", EFFECT_MAP_SPHERICAL, map_spherical, surface, ""},
        {"mapping: cylindrical", EFFECT_MAP_CYLINDRICAL, map_cylindrical, surface, ""},
        {"mapping: planar", EFFECT_MAP_PLANAR, map_planar, surface, ""},
        {"bump: waves", EFFECT_BUMP_WAVES, bump_waves, surface, ""},
        {"bump: noise", EFFECT_BUMP_NOISE, bump_noise, surface, ""},
        {"bump: height image", EFFECT_BUMP_HEIGHT, bump_height, pictures, ""},
        {"bump: normal map", EFFECT_NORMAL_MAP, normal_map, pictures, ""},
        {"environment: mirrored", EFFECT_MIRROR_ENVIRONMENT, mirror_environment, pictures, ""},
        {"environment: rendered", EFFECT_RENDERED_CUBE, rendered_environment, pictures, ""},
        {"environment: background", EFFECT_BACKGROUND_MAP, background_map, {}, ""},
        {"environment: six faces", EFFECT_SIX_FACES, six_faces, {}, ""},
        {"transparency", EFFECT_TRANSPARENCY, transparency, surface, "", RAY_STRAIGHT},
        {"transmission", 0, transmission, surface, "drawn as opacity 1 - kt, nothing is refracted", RAY_REFRACTED},
        {"reflection", 0, reflection, surface, "drawn without what they would mirror", RAY_REFLECTED},
        {"fresnel", 0, fresnel, surface, "drawn without the split of reflection and transmission", RAY_FRESNEL},
        {"scatter", 0, scatter, surface, "drawn as if polished", RAY_SCATTER},
        {"dispersion", 0, dispersion, surface, "drawn without colors split", RAY_DISPERSION},
        {"shadows", 0, shadows, light, "", RAY_SHADOWS},
        {"shadows: clear", 0, clear_shadows, surface, "", RAY_CLEAR_SHADOWS},
        {"adaptive depth", 0, cutoff, {}, "", RAY_CUTOFF},
        {"counters", 0, counters, {}, "", RAY_COUNT},
    };
    return rows;
}

} // namespace

std::span<const Effect> effects() {
    return table();
}

bool is_lit(const Facts& f, const Request& r) {
    return f.lights > 0 && (f.diffuse_materials > 0 || f.specular_materials > 0 || r.terms);
}

} // namespace lightbench
