// How an object stands in the world: the linear part of its transform, what that does to normals and windings, and where it is put.
// Surfaces are cut in world axes about an anchor of their own, and the anchor is added last: far from the origin nothing is lost.
#pragma once

#include "scene/scene.h"

#include <optional>

namespace lightbench {

struct Placement {
    glm::dmat3 linear{1};                // world axes from object axes
    glm::dvec3 translation{0};           // world
    glm::dmat3 normal{1};                // takes normals to normals, not unit
    bool mirrored = false;               // windings are turned
    double stretch = 1;                  // no length grows by more
    std::optional<double> similarity{1}; // the scale, if every direction is scaled alike
};

Placement placement_of(const glm::dmat4& world_from_object);

// Takes normals of a surface to normals of its image under `linear`: the matrix of cofactors, turned if it mirrors, so that outward stays
// outward. It is the inverse transpose times |det|, without the division that a determinant of 1e-18 or 0 would spoil (NI-2).
glm::dmat3 normal_matrix(const glm::dmat3& linear);

// Unit vectors that span, with the unit vector `axis`, a right-handed frame: x, y, axis.
struct Plane {
    glm::dvec3 x, y;
};
Plane plane_across(const glm::dvec3& axis);

} // namespace lightbench
