// Generated sets of primitives, and rays tested against them in double precision, for the tests of structures.
#pragma once

#include "accel/accel.h"

#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace lightbench::accel_tests {

using namespace gpu_layout;

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double in(double low, double high) { return low + (high - low) * (double(engine_()) / 4294967296.0); }
    std::uint32_t below(std::uint32_t n) { return engine_() % n; }
    glm::dvec3 point(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 p = point(1);
            if (const double l = glm::length(p); l > 0.1 && l <= 1) return p / l;
        }
    }

  private:
    std::mt19937 engine_;
};

inline void add_triangle(RayPrimitives& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    p.triangles.push_back({a, 0, b, 0, c, 0});
}

inline void add_sphere(RayPrimitives& p, const glm::vec3& center, float radius) {
    p.spheres.push_back({center, radius, 0, 0, 0, 0});
}

inline void add_shape(RayPrimitives& p, uint kind, const glm::dmat3& back, const glm::vec3& center, float p0 = 0, float p1 = 0) {
    const glm::mat3 rows(glm::transpose(glm::inverse(back))), columns(glm::transpose(back));
    p.shapes.push_back({rows[0], center.x, rows[1], center.y, rows[2],    center.z, kind,       p0, p1,         1,
                        0,       0,        0,       0,        columns[0], 0,        columns[1], 0,  columns[2], 0});
}

inline void number(RayPrimitives& p) {
    std::uint32_t n = 0;
    for (auto& t : p.triangles) t.number = t.object = n++;
    for (auto& s : p.spheres) s.number = s.object = n++;
    for (auto& s : p.shapes) s.number = s.object = n++;
}

inline glm::dmat3 random_back(Random& random, double size) {
    glm::dmat3 m;
    do {
        for (int i = 0; i < 3; ++i) m[i] = random.in(0.1, 1) * size * random.direction();
    } while (std::abs(glm::determinant(m)) < 1e-3 * size * size * size);
    return m;
}

// Kinds of sets that structures find hard; each several sizes and seeds.
enum class Kind { spheres, triangles, mixed, clustered, overlapping, planes, coincident, slivers };
constexpr int kKinds = 8;

inline RayPrimitives generate(Kind kind, std::uint32_t n, std::uint32_t seed) {
    Random r(seed);
    RayPrimitives p;
    const double size = 1.2 / std::cbrt(double(n));
    for (std::uint32_t i = 0; i < n; ++i) {
        const glm::vec3 c(r.point(1));
        const auto corner = [&](double s) { return c + glm::vec3(r.point(s)); };
        const auto quarter = [&] { return 0.25f * (float(r.below(9)) - 4); };
        switch (kind) {
        case Kind::spheres: add_sphere(p, c, float(r.in(0.1, 1) * size)); break;
        case Kind::triangles: add_triangle(p, corner(size), corner(size), corner(size)); break;
        case Kind::mixed:
            if (i % 6 == 0)
                add_sphere(p, c, float(0.4 * size));
            else if (i % 6 == 1)
                add_triangle(p, corner(size), corner(size), corner(size));
            else
                add_shape(p, i % 6 - 2, random_back(r, 0.7 * size), c, float(r.in(0.2, 0.8)), float(r.in(0, 1)));
            break;
        case Kind::clustered: add_sphere(p, i % 8 == 0 ? c : 1e-4f * c + 0.3f, i % 8 == 0 ? 0.1f : 1e-6f); break;
        case Kind::overlapping: add_sphere(p, 0.1f * c, float(r.in(0.5, 0.9))); break;
        case Kind::planes: { // sides that lie on planes of every grid
            const int axis = int(r.below(3));
            glm::vec3 a(quarter(), quarter(), quarter()), b = a, d = a;
            b[(axis + 1) % 3] += 0.25f, d[(axis + 2) % 3] += 0.25f;
            add_triangle(p, a, b, d);
            break;
        }
        case Kind::coincident:
            if (i % 2 == 0)
                add_sphere(p, {0.25f, 0.25f, 0.25f}, 0.5f);
            else
                add_triangle(p, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
            break;
        case Kind::slivers: add_triangle(p, c, -c + 1e-3f, corner(1e-3)); break;
        }
    }
    number(p);
    return p;
}

struct TestRay {
    glm::dvec3 o, d;
};

// From inside and outside, some along axes, some in planes of quarters.
inline TestRay random_ray(Random& r) {
    TestRay ray{r.point(r.below(2) == 0 ? 1 : 2), r.direction()};
    const std::uint32_t way = r.below(8);
    if (way < 2) ray.d[int(r.below(3))] = way == 0 ? 0.0 : -0.0;
    if (way == 2) ray.d = glm::dvec3(0), ray.d[int(r.below(3))] = r.below(2) == 0 ? 1 : -1;
    if (way < 4) ray.o = glm::round(4.0 * ray.o) / 4.0;
    if (way == 4) ray.d = -ray.o + r.point(0.3);
    ray.d = glm::normalize(ray.d);
    return ray;
}

struct Found {
    double t = std::numeric_limits<double>::infinity();
    std::uint32_t number = kNothing;
    void offer(double at, std::uint32_t n) {
        if (at > 0 && (at < t || (at == t && n < number))) t = at, number = n;
    }
};

// Exact enough that what it finds lies in any box that is rounded outwards.
void test(const RayTriangle& triangle, const TestRay& ray, Found& found);
void test(const RaySphere& sphere, const TestRay& ray, Found& found);
void test(const RayShape& shape, const TestRay& ray, Found& found);
void test_reference(const RayPrimitives& p, std::uint32_t reference, const TestRay& ray, Found& found);
void test_leaf(const RayPrimitives& p, std::uint32_t reference, const TestRay& ray, Found& found);
Found test_all(const RayPrimitives& p, const TestRay& ray);

// Walks over the tables as the shaders go, in double.
Found walk_wide(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray);
Found walk_narrow(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray);
Found walk_spheres(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray);
Found walk_grid(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray);
Found walk_octree(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray);

} // namespace lightbench::accel_tests
