// Placement of objects: linear part, normal matrix, winding, largest stretch. In: a transform. Out: what tessellation needs of it.
#include "scene/tessellate_placement.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

// The largest stretch of `linear` is the root of the largest eigenvalue of its Gram matrix, which no row sum of it falls below
// (Gershgorin 1931); for a similarity the bound is exact up to rounding.
double stretch_of(const glm::dmat3& gram) {
    double largest = 0;
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(gram[i].x) + std::abs(gram[i].y) + std::abs(gram[i].z));
    return std::sqrt(largest);
}

// Rotations that a file holds as rounded doubles, composed a few times, are orthogonal within some 1e-15; 1e-12 leaves room, and a
// direction scaled wrongly by that much is far below the float32 that vertices end in.
constexpr double kSimilarityTolerance = 1e-12;

std::optional<double> similarity_of(const glm::dmat3& gram) {
    const double square = (gram[0][0] + gram[1][1] + gram[2][2]) / 3;
    const glm::dmat3 rest = gram - glm::dmat3(square);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(rest[i][j]) <= kSimilarityTolerance * square)) return std::nullopt;
    return std::sqrt(square);
}

} // namespace

glm::dmat3 normal_matrix(const glm::dmat3& linear) {
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]), glm::cross(linear[0], linear[1]));
    const double determinant = glm::dot(linear[0], cofactors[0]);
    return determinant < 0 ? -cofactors : cofactors;
}

Placement placement_of(const glm::dmat4& world_from_object) {
    const glm::dmat3 linear(world_from_object);
    const glm::dmat3 gram = glm::transpose(linear) * linear;
    const bool mirrored = glm::dot(linear[0], glm::cross(linear[1], linear[2])) < 0;
    return {linear, glm::dvec3(world_from_object[3]), normal_matrix(linear), mirrored, stretch_of(gram), similarity_of(gram)};
}

Plane plane_across(const glm::dvec3& axis) {
    const glm::dvec3 size = glm::abs(axis);
    glm::dvec3 helper(0);
    helper[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
    const glm::dvec3 x = glm::normalize(glm::cross(helper, axis));
    return {x, glm::cross(axis, x)};
}

} // namespace lightbench
