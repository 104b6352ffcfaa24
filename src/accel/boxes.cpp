// Boxes about primitives, by support functions in double, padded and rounded outwards. In: RayPrimitives. Out: FloatBox by number.
#include "accel/primitives.h"

#include <cmath>

namespace lightbench {
namespace {

using namespace gpu_layout;

// kWalkError. A structure must not lose a hit that the test of every primitive finds, and a tested ray is as far off as its roundings: of points within
// 6 units of its origin (rays start within 4 units of the frame's origin, the scene lies within 2), each by 2^-24 of that distance, and no
// test makes more than 10 such roundings across the ray: 60 * 2^-24 < 2^-18. Of shapes, whose tests are made in their own space, roundings
// of linear * (o - center) come back through `back`: times a row sum of |back| |linear|, which is at least 1.
// A walk over planes computes (origin + k * step - o) / d: four roundings.

float below(double x) {
    const auto f = static_cast<float>(x);
    return f <= x ? f : std::nextafter(f, -INFINITY);
}

float above(double x) {
    const auto f = static_cast<float>(x);
    return f >= x ? f : std::nextafter(f, INFINITY);
}

FloatBox padded(const glm::dvec3& min, const glm::dvec3& max, const glm::dvec3& pad) {
    const glm::dvec3 lo = min - pad, hi = max + pad;
    return {{below(lo.x), below(lo.y), below(lo.z)}, {above(hi.x), above(hi.y), above(hi.z)}};
}

// `radius` about the rounded center, padded.
glm::vec4 sphere_of(const glm::vec3& center, double radius) {
    constexpr double kDiagonal = 1.7320508075688774; // of the cube that the padding of a point is
    return {center, above((radius + kDiagonal * kWalkError) * (1 + 0x1p-50))};
}

FloatBox box_of(const RayTriangle& t) {
    return padded(glm::min(t.v0, glm::min(t.v1, t.v2)), glm::max(t.v0, glm::max(t.v1, t.v2)), glm::dvec3(kWalkError));
}

FloatBox box_of(const RaySphere& s) {
    const glm::dvec3 center(s.center);
    return padded(center - double{s.radius}, center + double{s.radius}, glm::dvec3(kWalkError));
}

struct Extent {
    double below = 0, above = 0; // of the center, both >= 0 unless a cone leaves its middle
};

// Extent of the shape along a frame axis: `row` is that row of back. A sum of sets has the sum of their extents: the torus is a circle plus
// a ball. A cone is the hull of its two discs.
Extent extent_of(const RayShape& s, const glm::dvec3& row) {
    const double disc = std::hypot(row.x, row.y), ball = glm::length(row);
    const double box = std::abs(row.x) + std::abs(row.y) + std::abs(row.z), torus = disc + s.p0 * ball;
    const double low_end = s.p0 * disc, high_end = s.p1 * disc;
    switch (s.kind) {
    case kShapeBox: return {box, box};
    case kShapeBall: return {ball, ball};
    case kShapeTorus: return {torus, torus};
    default: return {std::max(row.z + low_end, high_end - row.z), std::max(low_end - row.z, row.z + high_end)};
    }
}

// The shape that rays meet is the one of the rounded rows of `linear`: its box is found from their inverse, not from the rounded `back`.
FloatBox box_of(const RayShape& s) {
    const glm::dmat3 linear = glm::transpose(glm::dmat3(s.row_x, s.row_y, s.row_z));
    const glm::dmat3 back = glm::inverse(linear);
    const glm::dvec3 center(s.center_x, s.center_y, s.center_z);
    glm::dvec3 min, max, pad;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 row(back[0][i], back[1][i], back[2][i]);
        const Extent extent = extent_of(s, row);
        min[i] = center[i] - extent.below, max[i] = center[i] + extent.above;
        const glm::dvec3 through = glm::abs(linear[0]) + glm::abs(linear[1]) + glm::abs(linear[2]); // row sums of |linear|
        pad[i] = kWalkError * glm::dot(glm::abs(row), through);
    }
    return padded(min, max, pad);
}

// About the middle of its box.
glm::vec4 sphere_of(const RayTriangle& t) {
    const glm::vec3 center = 0.5f * glm::min(t.v0, glm::min(t.v1, t.v2)) + 0.5f * glm::max(t.v0, glm::max(t.v1, t.v2));
    double radius = 0;
    for (const glm::vec3& v : {t.v0, t.v1, t.v2}) radius = std::max(radius, glm::length(glm::dvec3(v) - glm::dvec3(center)));
    return sphere_of(center, radius);
}

glm::vec4 sphere_of(const RaySphere& s) {
    return sphere_of(s.center, s.radius);
}

glm::vec4 sphere_of(const RayShape& s) {
    const FloatBox box = box_of(s);
    const glm::vec3 center = 0.5f * box.min + 0.5f * box.max;
    const glm::dvec3 c(center);
    return sphere_of(center, glm::length(glm::max(glm::dvec3(box.max) - c, c - glm::dvec3(box.min))));
}

} // namespace

std::vector<glm::vec4> spheres_of(const RayPrimitives& primitives) {
    std::vector<glm::vec4> spheres(primitives.size());
    for (const auto& triangle : primitives.triangles) spheres[triangle.number] = sphere_of(triangle);
    for (const auto& sphere : primitives.spheres) spheres[sphere.number] = sphere_of(sphere);
    for (const auto& shape : primitives.shapes) spheres[shape.number] = sphere_of(shape);
    return spheres;
}

std::vector<FloatBox> boxes_of(const RayPrimitives& primitives) {
    std::vector<FloatBox> boxes(primitives.size());
    for (const auto& triangle : primitives.triangles) boxes[triangle.number] = box_of(triangle);
    for (const auto& sphere : primitives.spheres) boxes[sphere.number] = box_of(sphere);
    for (const auto& shape : primitives.shapes) boxes[shape.number] = box_of(shape);
    return boxes;
}

} // namespace lightbench
