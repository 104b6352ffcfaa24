// From a value an element to a value a corner, for Gouraud shading (S32). In: PatchMesh, values. Out: values at corners. Pure.
#pragma once

#include "radiosity/patches.h"

#include <span>

namespace lightbench {

// Four a element (a triangle's last is unused), >= 0. Corners of one point and one group have one value; across groups none is shared.
// Cohen and Greenberg 1985, "The Hemi-cube", sec. 6: inside a mesh the mean of the elements around a corner; on its border what continues the
// inside linearly. Weights are those of the areas where these differ. Elements that are covered take no part.
std::vector<std::array<glm::vec3, 4>> corner_values(const PatchMesh& mesh, std::span<const glm::vec3> of_elements);

} // namespace lightbench
