// Rays against primitives in double precision, by forms that the shaders do not use.
#include "accel_support.h"

#include <cmath>

namespace lightbench::accel_tests {
namespace {

// Object space: the direction keeps its length, so that t is that of the frame.
TestRay local(const RayShape& s, const TestRay& ray) {
    const glm::dmat3 linear = glm::transpose(glm::dmat3(s.row_x, s.row_y, s.row_z));
    return {linear * (ray.o - glm::dvec3(s.center_x, s.center_y, s.center_z)), linear * ray.d};
}

void test_quadratic(double a, double b, double c, const auto& accept) {
    const double root = std::sqrt(b * b - a * c);
    if (a != 0 && root >= 0) accept((-b - root) / a), accept((-b + root) / a);
}

void test_cube(const TestRay& r, std::uint32_t number, Found& found) {
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0}) {
            const double t = (side - r.o[axis]) / r.d[axis];
            const glm::dvec3 p = glm::abs(r.o + t * r.d);
            if (std::isfinite(t) && p[(axis + 1) % 3] <= 1 && p[(axis + 2) % 3] <= 1) found.offer(t, number);
        }
}

// Radius m + k z at z.
void test_cone(const RayShape& s, const TestRay& r, Found& found) {
    const double m = 0.5 * (double{s.p0} + double{s.p1}), k = 0.5 * (double{s.p1} - double{s.p0});
    const double w = m + k * r.o.z, dw = k * r.d.z;
    test_quadratic(r.d.x * r.d.x + r.d.y * r.d.y - dw * dw, r.o.x * r.d.x + r.o.y * r.d.y - w * dw, r.o.x * r.o.x + r.o.y * r.o.y - w * w,
                   [&](double t) {
                       if (std::abs(r.o.z + t * r.d.z) <= 1) found.offer(t, s.number);
                   });
    for (double side : {-1.0, 1.0}) {
        const double t = (side - r.o.z) / r.d.z, radius = m + k * side;
        const glm::dvec3 p = r.o + t * r.d;
        if (std::isfinite(t) && p.x * p.x + p.y * p.y <= radius * radius) found.offer(t, s.number);
    }
}

// The first change of sign among 400 samples of the way through the ball about it, bisected.
void test_torus(const RayShape& s, const TestRay& r, Found& found) {
    const double minor = s.p0, reach = 1.01 * (1 + minor), length = glm::length(r.d), middle = -glm::dot(r.o, r.d) / (length * length);
    const glm::dvec3 nearest = r.o + middle * r.d;
    if (glm::length(nearest) > reach) return;
    const auto inside = [&](double t) {
        const glm::dvec3 p = r.o + t * r.d;
        const double across = std::hypot(p.x, p.y) - 1;
        return across * across + p.z * p.z < minor * minor;
    };
    double before = std::max(0.0, middle - reach / length);
    const double last = middle + reach / length, step = (last - before) / 400;
    for (double t = before; t < last; before = t, t += step) {
        if (inside(t) == inside(before)) continue;
        double low = before, high = t;
        for (int i = 0; i < 60; ++i) (inside(0.5 * (low + high)) == inside(before) ? low : high) = 0.5 * (low + high);
        return found.offer(high, s.number);
    }
}

} // namespace

// Moller, Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
void test(const RayTriangle& triangle, const TestRay& ray, Found& found) {
    const glm::dvec3 a(triangle.v0), e1 = glm::dvec3(triangle.v1) - a, e2 = glm::dvec3(triangle.v2) - a, p = glm::cross(ray.d, e2);
    const double det = glm::dot(e1, p);
    if (det == 0) return;
    const glm::dvec3 s = ray.o - a, q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / det, v = glm::dot(ray.d, q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1) found.offer(glm::dot(e2, q) / det, triangle.number);
}

void test(const RaySphere& sphere, const TestRay& ray, Found& found) {
    const glm::dvec3 to = ray.o - glm::dvec3(sphere.center);
    const double r = sphere.radius;
    test_quadratic(glm::dot(ray.d, ray.d), glm::dot(to, ray.d), glm::dot(to, to) - r * r, [&](double t) { found.offer(t, sphere.number); });
}

void test(const RayShape& shape, const TestRay& ray, Found& found) {
    const TestRay r = local(shape, ray);
    if (shape.kind == kShapeBox) test_cube(r, shape.number, found);
    if (shape.kind == kShapeBall)
        test_quadratic(glm::dot(r.d, r.d), glm::dot(r.o, r.d), glm::dot(r.o, r.o) - 1, [&](double t) { found.offer(t, shape.number); });
    if (shape.kind == kShapeCone) test_cone(shape, r, found);
    if (shape.kind == kShapeTorus) test_torus(shape, r, found);
}

void test_reference(const RayPrimitives& p, std::uint32_t reference, const TestRay& ray, Found& found) {
    const std::uint32_t type = reference >> kRefType & 3u, index = reference & kRefIndex;
    if (type == kTypeTriangle) return test(p.triangles.at(index), ray, found);
    if (type == kTypeSphere) return test(p.spheres.at(index), ray, found);
    test(p.shapes.at(index), ray, found);
}

void test_leaf(const RayPrimitives& p, std::uint32_t reference, const TestRay& ray, Found& found) {
    const std::uint32_t type = reference & 3u << kRefType;
    for (std::uint32_t i = 0; i <= (reference >> kRefCount & 3u); ++i) test_reference(p, type | ((reference & kRefIndex) + i), ray, found);
}

Found test_all(const RayPrimitives& p, const TestRay& ray) {
    Found found;
    for (const auto& triangle : p.triangles) test(triangle, ray, found);
    for (const auto& sphere : p.spheres) test(sphere, ray, found);
    for (const auto& shape : p.shapes) test(shape, ray, found);
    return found;
}

} // namespace lightbench::accel_tests
