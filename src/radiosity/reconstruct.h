// From a value an element to a value a corner, for Gouraud shading (S32). In: PatchMesh, values. Out: values at corners. Pure.
#pragma once

#include "radiosity/patches.h"

#include <span>

namespace lightbench {

// Four a element (a triangle's last is unused), >= 0. Corners of one point and one group have one value; across groups none is shared.
// Cohen and Greenberg 1985, "The Hemi-cube", sec. 6: inside a mesh the mean of the elements around a corner; on its border what continues
// the inside linearly: B1 + B2 - B_E beside two quadrilaterals whose common edge leads to the inner point E, 2 B1 - B_E in the corner of
// one whose opposite corner is E; anywhere else (triangles, corners that turn inwards) the plane fitted by least squares to the elements
// that share a point with those around the corner, through their mean; their mean where no inner point or no plane is to be had (1 x 1, 1 x
// n). Weights are those of the areas where these differ. Elements that are covered take no part; a corner that only such meet in has the
// mean of their corners that are known, or 0.
std::vector<std::array<glm::vec3, 4>> corner_values(const PatchMesh& mesh, std::span<const glm::vec3> of_elements);

} // namespace lightbench
