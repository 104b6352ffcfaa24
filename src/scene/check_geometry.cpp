// Degenerate polygons and cameras.
#include "scene/check_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lightbench {
namespace {

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

struct Extent {
    double farthest = 0; // largest coordinate, from the origin of the file
    double size = 0;     // largest coordinate, from the first point
};

Extent extent_of(std::span<const glm::dvec3> points) {
    Extent e;
    for (const glm::dvec3& p : points) e.farthest = std::max(e.farthest, largest(p)), e.size = std::max(e.size, largest(p - points[0]));
    return e;
}

} // namespace

glm::dvec3 area_vector(std::span<const glm::dvec3> points) {
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) sum += glm::cross(points[i] - points[0], points[i + 1] - points[0]);
    return sum;
}

// Rounding: decimal to double moves a point by eps/2 * farthest, the differences by as much again, each of the n cross products by
// 2 * eps * size^2. With both factors at most sqrt(3) * size long, n products err by less than n * size * (4 sqrt(3) eps farthest + 6 eps size),
// so 8 n eps size (farthest + size) covers it.
bool has_no_area(std::span<const glm::dvec3> points) {
    if (points.size() < 3) return true;
    const Extent e = extent_of(points);
    const double rounding =
        8 * static_cast<double>(points.size()) * std::numeric_limits<double>::epsilon() * e.size * (e.farthest + e.size);
    return glm::length(area_vector(points)) <= rounding;
}

// Allowed: files print six digits, which moves each coordinate by up to 5e-6 of itself and a point by sqrt(3) times that; the mean plane
// moves by as much, and tilts by up to as much again over the polygon: 4 * sqrt(3) * 5e-6 = 3.5e-5 of the largest coordinate. But never
// more than 1/100 of the polygon's own size, or far from the origin anything would pass.
Planarity planarity_of(std::span<const glm::dvec3> points) {
    const Extent e = extent_of(points);
    const glm::dvec3 n = glm::normalize(area_vector(points));
    glm::dvec3 mean(0);
    for (const glm::dvec3& p : points) mean += (p - points[0]) / static_cast<double>(points.size());
    Planarity result;
    result.allowed = std::min(3.5e-5 * e.farthest, 0.01 * e.size);
    for (const glm::dvec3& p : points) result.deviation = std::max(result.deviation, std::abs(glm::dot(p - points[0] - mean, n)));
    return result;
}

// Positions are doubles: a difference below 1e-12 of the coordinates has lost all but four of its sixteen digits.
bool has_no_direction(const Camera& camera) {
    const double size = std::max(largest(camera.position), largest(camera.target));
    return largest(camera.target - camera.position) <= 1e-12 * size;
}

// The sideways axis is cross(view, up): where its sine is below 1e-6, six-digit files no longer say which way it points.
bool up_is_along_view(const Camera& camera) {
    const glm::dvec3 view = camera.target - camera.position;
    const glm::dvec3 side = glm::cross(view / largest(view), camera.up / std::max(largest(camera.up), std::numeric_limits<double>::min()));
    return !(largest(side) > 1e-6);
}

} // namespace lightbench
