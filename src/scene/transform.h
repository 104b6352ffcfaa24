// The transform of an object as people write it, and as a matrix: both ways. RULINGS: translate * rotateZ * rotateY * rotateX * scale.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace lightbench {

struct TransformParts {
    glm::dvec3 translate{0}; // metres
    glm::dvec3 rotate{0};    // degrees about x, y, z
    glm::dvec3 scale{1};     // one negative factor mirrors
};

// Exact where every angle is a multiple of 90 degrees.
glm::dmat4 world_from_object(const TransformParts& placement);

// The placement whose matrix this is, within 1e-13 of each column's length, in the shortest numbers that give it; none if the matrix shears,
// flattens or projects.
std::optional<TransformParts> transform_parts(const glm::dmat4& world_from_object);

} // namespace lightbench
