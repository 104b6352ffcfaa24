// Can this be drawn at all? Pure predicates on shapes and cameras, shared by the loaders, each with the derivation of its tolerance.
#pragma once

#include "scene/scene.h"

#include <span>

namespace lightbench {

// Twice the area times the normal of a polygon in space (Newell; Sutherland, Sproull and Schumacker 1974, "A Characterization of Ten
// Hidden-Surface Algorithms", sec. on plane equations), taken about its first point so that a distant polygon loses no digits.
glm::dvec3 area_vector(std::span<const glm::dvec3> points);

// All points on one line, within the rounding of the double arithmetic that finds out.
bool has_no_area(std::span<const glm::dvec3> points);

struct Planarity {
    double deviation = 0; // metres, of the point that is farthest from the mean plane
    double allowed = 0;   // metres
    bool planar() const { return deviation <= allowed; }
};
Planarity planarity_of(std::span<const glm::dvec3> points);

// The two ways in which a camera has no view; up is judged only where there is a direction.
bool has_no_direction(const Camera& camera);
bool up_is_along_view(const Camera& camera);

} // namespace lightbench
