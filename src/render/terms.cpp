#include "render/terms.h"

#include "gpu/check.h"
#include "shared/effects.h"

namespace lightbench {
namespace {

constexpr std::uint32_t kLights = EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT | EFFECT_ATTENUATION_NONE |
                                  EFFECT_ATTENUATION_LINEAR | EFFECT_ATTENUATION_INVERSE_SQUARE | EFFECT_COMPENSATED_SUM;
constexpr std::uint32_t kSurface = EFFECT_TWO_SIDED | EFFECT_MANY_MATERIALS | EFFECT_VANISHING_NORMALS | EFFECT_ANY_BUMP |
                                   EFFECT_ANY_TEXTURE | EFFECT_TEXTURE_ALPHA | EFFECT_ANY_MAPPING | EFFECT_TRANSPARENCY;

// The light terms (the first six) add up to the image; the others tell how it came about.
constexpr Term kTerms[] = {
    {"ambient", EFFECT_AMBIENT | kSurface, OUTPUT_RADIANCE, true, false},
    {"diffuse", EFFECT_DIFFUSE | kLights | kSurface, OUTPUT_RADIANCE, true, false},
    {"specular", EFFECT_SPECULAR | EFFECT_COOK_TORRANCE | kLights | kSurface, OUTPUT_RADIANCE, true, false},
    {"emission", EFFECT_EMISSION | kSurface, OUTPUT_RADIANCE, true, false},
    {"reflected", EFFECT_MIRROR_ENVIRONMENT | EFFECT_SIX_FACES | EFFECT_RENDERED_CUBE | EFFECT_COOK_TORRANCE | kSurface, OUTPUT_RADIANCE,
     true, false},
    {"background", EFFECT_BACKGROUND_MAP | EFFECT_SIX_FACES | kSurface, OUTPUT_RADIANCE, true, true},
    {"attenuation", kLights | kSurface, OUTPUT_ATTENUATION, true, false},
    {"normal", kSurface, OUTPUT_NORMAL, false, false},
    {"depth", kSurface, OUTPUT_DEPTH, false, false},
    {"object", kSurface, OUTPUT_OBJECT, false, false},
};

} // namespace

Term find_term(std::string_view name) {
    for (const Term& term : kTerms)
        if (term.name == name) return term;
    CHECK(false, "no term is named {}", name);
    return {};
}

} // namespace lightbench
