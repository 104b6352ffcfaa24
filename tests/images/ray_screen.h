// Scenes that show where an eye ray lands: a white screen whose three point lights give each place a color of its own.
#pragma once

#include "images/ray_reference.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>

namespace lightbench::testing {

constexpr double kDegree = std::numbers::pi / 180;

// A screen in the plane through `center` across `normal`, lit from `normal`'s side at a distance of 1.5.
struct Screen {
    glm::dvec3 center, normal, x, y;
    double size = 8;

    glm::dvec3 light(int i) const { return center + 1.5 * normal + 2.0 * (std::cos(i * 2.1) * x + std::sin(i * 2.1) * y); }
    glm::dvec3 radiance(const glm::dvec3& p) const {
        glm::dvec3 sum(0);
        for (int i = 0; i < 3; ++i) sum[i] = 1.5 / glm::length(light(i) - p);
        return sum;
    }
    std::optional<glm::dvec3> meet(const glm::dvec3& o, const glm::dvec3& d) const {
        const double t = glm::dot(center - o, normal) / glm::dot(d, normal);
        const glm::dvec3 p = o + t * d;
        if (!(t > 0) || std::max(std::abs(glm::dot(p - center, x)), std::abs(glm::dot(p - center, y))) > 0.99 * size) return std::nullopt;
        return p;
    }
};

inline const Screen kFloor{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};

inline Scene screen_scene(const Screen& screen, const glm::dvec3& eye, const glm::dvec3& target, double fov) {
    Scene scene;
    Camera camera;
    camera.position = eye, camera.target = target, camera.fov = fov;
    if (std::abs(glm::normalize(target - eye).y) > 0.99) camera.up = {0, 0, -1};
    scene.cameras = {camera};
    Material white;
    white.diffuse = glm::vec3(1);
    scene.materials = {white};
    const glm::dvec3 x = screen.size * screen.x, y = screen.size * screen.y;
    Object object;
    object.shape = Polygon{{screen.center - x - y, screen.center + x - y, screen.center + x + y, screen.center - x + y}, {}};
    scene.objects = {object};
    for (int i = 0; i < 3; ++i) {
        glm::vec3 color(0);
        color[i] = 1;
        scene.lights.push_back(point_light(screen.light(i), color));
    }
    return scene;
}

inline Material glass(float n) {
    Material m;
    m.diffuse = glm::vec3(0), m.transmission = glm::vec3(1), m.ior = glm::vec3(n);
    return m;
}

inline Material mirror(float kr = 1) {
    Material m;
    m.diffuse = glm::vec3(0), m.reflection = glm::vec3(kr);
    return m;
}

inline void add(Scene& scene, const Shape& shape, const Material& m) {
    Object object;
    object.shape = shape, object.material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(m), scene.objects.push_back(object);
}

inline Box slab(double bottom, double top) {
    return {{-20, bottom, -20}, {20, top, 20}};
}

// Where the eye ray in direction d lands, if the closed form knows.
using Landing = std::function<std::optional<glm::dvec3>(const glm::dvec3& d)>;

inline void expect_landing(const Scene& scene, const Screen& screen, const Landing& landing, double tolerance,
                           glm::dvec3 factor = glm::dvec3(1)) {
    const Rendered r = render_scene(scene, ray_request({47, 35}, 12));
    unsigned seen = 0;
    for (unsigned y = 0; y < 35; ++y)
        for (unsigned x = 0; x < 47; ++x) {
            const auto p = landing(r.view.direction_through({x + 0.5, y + 0.5}));
            if (!p) continue;
            const glm::dvec3 want = factor * screen.radiance(*p), got = pixel(*r.output.radiance, x, y);
            ASSERT_LT(glm::length(got - want), tolerance * glm::length(want))
                << x << ' ' << y << ": " << got.x << ' ' << got.y << ' ' << got.z << " for " << want.x << ' ' << want.y << ' ' << want.z;
            ++seen;
        }
    EXPECT_GT(seen, 47u * 35 / 2);
}

} // namespace lightbench::testing
