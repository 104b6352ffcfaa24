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

// a b - c d to 1.5 ulp. Kahan 2004; Jeannerod, Louvet, Muller 2013, "Further analysis of Kahan's algorithm for the accurate computation of
// 2x2 determinants". Of a matrix whose scales are 1e12 apart a plain difference would leave 4 digits.
double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d, rounding = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + rounding;
}

glm::dvec3 accurate_cross(const glm::dvec3& a, const glm::dvec3& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

glm::dmat3 cofactors_of(const glm::dmat3& m) {
    return {accurate_cross(m[1], m[2]), accurate_cross(m[2], m[0]), accurate_cross(m[0], m[1])};
}

double determinant(const glm::dmat3& m, const glm::dmat3& cofactors) {
    return glm::dot(m[0], cofactors[0]);
}

} // namespace

glm::dmat3 normal_matrix(const glm::dmat3& linear) {
    const glm::dmat3 cofactors = cofactors_of(linear);
    return determinant(linear, cofactors) < 0 ? -cofactors : cofactors;
}

Placement placement_of(const glm::dmat4& world_from_object) {
    const glm::dmat3 linear(world_from_object);
    const glm::dmat3 gram = glm::transpose(linear) * linear;
    const bool mirrored = determinant(linear, cofactors_of(linear)) < 0;
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
