// Boxes about primitives, by support functions in double, padded and rounded outwards. In: RayPrimitives. Out: FloatBox by number.
#include "accel/primitives.h"

#include <cmath>

namespace lightbench {
namespace {

using namespace gpu_layout;

// Padding is along each axis. Of a point at most R from the origin of its ray, u = 2^-24: no test is off by more than 10 u R across the ray,
// and 24 u R along it (shaders/lib/ray_box.glsl); a plane origin + k * step is met to 4 u R. 64 u R is more than all of these together,
// and is also what 24 u R along the ray in one voxel and 4 u R of the walk leave for the other.
// Tests of shapes are made in their own space, where linear * (o - center) is off by 6 u |linear| R: their padding goes through `back`, times
// a row sum of |back| |linear|, which is at least 1.
constexpr double kRoundings = 64 * 0x1p-24;
constexpr double kFrameRadius = 2; // scene/tessellate.h: the scene lies within

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
glm::vec4 sphere_of(const glm::vec3& center, double radius, double error) {
    constexpr double kDiagonal = 1.7320508075688774; // of the cube that the padding of a point is
    return {center, above((radius + kDiagonal * error) * (1 + 0x1p-50))};
}

FloatBox box_of(const RayTriangle& t, double error) {
    return padded(glm::min(t.v0, glm::min(t.v1, t.v2)), glm::max(t.v0, glm::max(t.v1, t.v2)), glm::dvec3(error));
}

FloatBox box_of(const RaySphere& s, double error) {
    const glm::dvec3 center(s.center);
    return padded(center - double{s.radius}, center + double{s.radius}, glm::dvec3(error));
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
FloatBox box_of(const RayShape& s, double error) {
    const glm::dmat3 linear = glm::transpose(glm::dmat3(s.row_x, s.row_y, s.row_z));
    const glm::dmat3 back = glm::inverse(linear);
    const glm::dvec3 center(s.center_x, s.center_y, s.center_z);
    glm::dvec3 min, max, pad;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 row(back[0][i], back[1][i], back[2][i]);
        const Extent extent = extent_of(s, row);
        min[i] = center[i] - extent.below, max[i] = center[i] + extent.above;
        const glm::dvec3 through = glm::abs(linear[0]) + glm::abs(linear[1]) + glm::abs(linear[2]); // row sums of |linear|
        pad[i] = error * glm::dot(glm::abs(row), through);
    }
    return padded(min, max, pad);
}

// About the middle of its box.
glm::vec4 sphere_of(const RayTriangle& t, double error) {
    const glm::vec3 center = 0.5f * glm::min(t.v0, glm::min(t.v1, t.v2)) + 0.5f * glm::max(t.v0, glm::max(t.v1, t.v2));
    double radius = 0;
    for (const glm::vec3& v : {t.v0, t.v1, t.v2}) radius = std::max(radius, glm::length(glm::dvec3(v) - glm::dvec3(center)));
    return sphere_of(center, radius, error);
}

glm::vec4 sphere_of(const RaySphere& s, double error) {
    return sphere_of(s.center, double{s.radius}, error);
}

glm::vec4 sphere_of(const RayShape& s, double error) {
    const FloatBox box = box_of(s, error);
    const glm::vec3 center = 0.5f * box.min + 0.5f * box.max;
    const glm::dvec3 c(center);
    return sphere_of(center, glm::length(glm::max(glm::dvec3(box.max) - c, c - glm::dvec3(box.min))), 0);
}

} // namespace

double error_of_rays(const RayPrimitives& primitives) {
    return kRoundings * (kFrameRadius + primitives.reach);
}

std::vector<glm::vec4> spheres_of(const RayPrimitives& primitives) {
    std::vector<glm::vec4> spheres(primitives.size());
    const double error = error_of_rays(primitives);
    for (const auto& triangle : primitives.triangles) spheres[triangle.number] = sphere_of(triangle, error);
    for (const auto& sphere : primitives.spheres) spheres[sphere.number] = sphere_of(sphere, error);
    for (const auto& shape : primitives.shapes) spheres[shape.number] = sphere_of(shape, error);
    return spheres;
}

std::vector<FloatBox> boxes_of(const RayPrimitives& primitives) {
    std::vector<FloatBox> boxes(primitives.size());
    const double error = error_of_rays(primitives);
    for (const auto& triangle : primitives.triangles) boxes[triangle.number] = box_of(triangle, error);
    for (const auto& sphere : primitives.spheres) boxes[sphere.number] = box_of(sphere, error);
    for (const auto& shape : primitives.shapes) boxes[shape.number] = box_of(shape, error);
    return boxes;
}

} // namespace lightbench
