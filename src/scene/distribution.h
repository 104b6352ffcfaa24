// What Cook-Torrance's kernels want to know of a material beforehand: the factor of the facet distribution, indices from reflectances.
// In: a distribution and its rms slope, or f0. Out: numbers in double, once per material (SPEC S6).
#pragma once

#include "scene/scene.h"

namespace lightbench {

// Smoother surfaces are shaded as this: below, the lobe of a point light is narrower than 0.1 degrees and its peak leaves what pictures
// hold.
constexpr double kLeastRoughness = 1e-3;

// The factor c of D = c exp(-(alpha/m)^2) (Gaussian), or of D = c exp(-tan^2(alpha)/m^2)/cos^4(alpha) (Beckmann), for which the integral of
// D cos(alpha) over the hemisphere is pi/4. m counts as kLeastRoughness where it is less.
// Error: relative 1e-8.
double lobe_factor(Distribution distribution, double m);

// The index of refraction whose reflectance at normal incidence is f0 in [0, 1), a channel each.
glm::vec3 ior_of_f0(glm::vec3 f0);

} // namespace lightbench
