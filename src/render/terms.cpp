#include "render/terms.h"

#include "gpu/check.h"
#include "shared/effects.h"
#include "shared/rays.h"

namespace lightbench {
namespace {

constexpr std::uint32_t kLights = EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT | EFFECT_ATTENUATION_NONE |
                                  EFFECT_ATTENUATION_LINEAR | EFFECT_ATTENUATION_INVERSE_SQUARE | EFFECT_COMPENSATED_SUM;
constexpr std::uint32_t kSurface = EFFECT_TWO_SIDED | EFFECT_MANY_MATERIALS | EFFECT_VANISHING_NORMALS | EFFECT_ANY_BUMP |
                                   EFFECT_ANY_TEXTURE | EFFECT_TEXTURE_ALPHA | EFFECT_ANY_MAPPING | EFFECT_TRANSPARENCY;

// The light terms (the first seven) add up to the image; the others tell how it came about.
constexpr Term kTerms[] = {
    {"ambient", EFFECT_AMBIENT | kSurface},
    {"diffuse", EFFECT_DIFFUSE | kLights | kSurface},
    {"specular", EFFECT_SPECULAR | EFFECT_COOK_TORRANCE | kLights | kSurface},
    {"emission", EFFECT_EMISSION | kSurface},
    {"reflected", EFFECT_MIRROR_ENVIRONMENT | EFFECT_SIX_FACES | EFFECT_RENDERED_CUBE | EFFECT_COOK_TORRANCE | kSurface, OUTPUT_RADIANCE,
     true, false, 1u << gpu_layout::kRayReflected},
    {"refracted", 0, OUTPUT_RADIANCE, true, false, 1u << gpu_layout::kRayRefracted | 1u << gpu_layout::kRayStraight},
    {"background", EFFECT_BACKGROUND_MAP | EFFECT_SIX_FACES | kSurface, OUTPUT_RADIANCE, true, true},
    {"shadow", EFFECT_DIFFUSE | EFFECT_SPECULAR | EFFECT_COOK_TORRANCE | kLights | kSurface, OUTPUT_SHADOW},
    {"attenuation", kLights | kSurface, OUTPUT_ATTENUATION},
    {"normal", kSurface, OUTPUT_NORMAL, false},
    {"depth", kSurface, OUTPUT_DEPTH, false},
    {"object", kSurface, OUTPUT_OBJECT, false},
};

} // namespace

Term find_term(std::string_view name) {
    for (const Term& term : kTerms)
        if (term.name == name) return term;
    CHECK(false, "no term is named {}", name);
    return {};
}

} // namespace lightbench
