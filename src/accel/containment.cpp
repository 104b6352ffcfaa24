// Inside or outside, primitive by primitive, in double.
#include "accel/containment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace lightbench {
namespace {

// Far from the axes and from the diagonals that modelled edges like to follow.
const glm::dvec3 kDirection = glm::normalize(glm::dvec3(0.36127, 0.54812, 0.75431));

// Larger root of |o + t d|^2 = 1.
std::optional<double> leave_ball(const glm::dvec3& o, const glm::dvec3& d) {
    if (glm::dot(o, o) >= 1) return std::nullopt;
    const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1;
    return (-b + std::sqrt(b * b - a * c)) / a;
}

std::optional<double> leave_box(const glm::dvec3& o, const glm::dvec3& d) {
    double t = INFINITY;
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(o[i]) < 1)) return std::nullopt;
        if (d[i] != 0) t = std::min(t, ((d[i] > 0 ? 1 : -1) - o[i]) / d[i]);
    }
    return t;
}

// Signed: negative inside.
double outside_of(const gpu_layout::RayShape& shape, const glm::dvec3& p) {
    const double rho = std::hypot(p.x, p.y);
    if (shape.kind == gpu_layout::kShapeTorus) return std::hypot(rho - 1, p.z) - double{shape.p0};
    const double radius = double{shape.p0} + (double{shape.p1} - double{shape.p0}) * 0.5 * (p.z + 1);
    return std::max(rho - radius, std::abs(p.z) - 1);
}

// Cones and tori: their outsides are looked for step by step, which is exact enough to put media into order.
std::optional<double> leave_by_steps(const gpu_layout::RayShape& shape, const glm::dvec3& o, const glm::dvec3& d) {
    if (outside_of(shape, o) >= 0 || (shape.kind == gpu_layout::kShapeCone && shape.p2 == 0)) return std::nullopt;
    constexpr int kSteps = 256;
    const double reach = 4 / glm::length(d); // the shape lies within 2 of its middle, but for a fat torus, which is left later
    for (int i = 1; i <= kSteps; ++i)
        if (outside_of(shape, o + (reach * i / kSteps) * d) >= 0) return reach * i / kSteps;
    return reach;
}

std::optional<double> leave(const gpu_layout::RayShape& s, const glm::dvec3& point) {
    const glm::dvec3 p = point - glm::dvec3(s.center_x, s.center_y, s.center_z), x(s.row_x), y(s.row_y), z(s.row_z);
    const glm::dvec3 o(glm::dot(x, p), glm::dot(y, p), glm::dot(z, p));
    const glm::dvec3 d(glm::dot(x, kDirection), glm::dot(y, kDirection), glm::dot(z, kDirection));
    if (s.kind == gpu_layout::kShapeBall) return leave_ball(o, d);
    if (s.kind == gpu_layout::kShapeBox) return leave_box(o, d);
    return leave_by_steps(s, o, d);
}

// Moeller and Trumbore 1997.
std::optional<double> cross(const gpu_layout::RayTriangle& t, const glm::dvec3& o) {
    const glm::dvec3 a(t.v0), e1 = glm::dvec3(t.v1) - a, e2 = glm::dvec3(t.v2) - a, p = glm::cross(kDirection, e2);
    const double det = glm::dot(e1, p);
    if (det == 0) return std::nullopt;
    const glm::dvec3 s = o - a, q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / det, v = glm::dot(kDirection, q) / det, at = glm::dot(e2, q) / det;
    if (u < 0 || v < 0 || u + v > 1 || at <= 0) return std::nullopt;
    return at;
}

struct Crossings {
    std::size_t count = 0;
    WayOut first{INFINITY, 0};
};

} // namespace

std::vector<WayOut> surfaces_around(const RayPrimitives& primitives, const glm::dvec3& point,
                                    const std::function<bool(std::uint32_t)>& counts) {
    std::vector<WayOut> found;
    for (const auto& s : primitives.spheres)
        if (counts(s.surface))
            if (const auto t = leave_ball((point - glm::dvec3(s.center)) / double{s.radius}, kDirection / double{s.radius}))
                found.push_back({*t, s.surface});
    for (const auto& s : primitives.shapes)
        if (counts(s.surface))
            if (const auto t = leave(s, point)) found.push_back({*t, s.surface});
    std::map<std::uint32_t, Crossings> of_objects;
    for (const auto& t : primitives.triangles)
        if (counts(t.surface))
            if (const auto at = cross(t, point)) {
                Crossings& object = of_objects[t.object];
                ++object.count;
                if (*at < object.first.distance) object.first = {*at, t.surface};
            }
    for (const auto& [object, crossings] : of_objects)
        if (crossings.count % 2 == 1) found.push_back(crossings.first);
    std::ranges::stable_sort(found, {}, &WayOut::distance);
    return found;
}

} // namespace lightbench
