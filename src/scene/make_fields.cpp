// Scenes that are many: a cubic grid of spheres, and a field of objects under many lights. In: how many. Metres.
#include "scene/make_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lightbench {
namespace {

// The least k with k^power >= n, in whole numbers: a rounded root would be one off just where n is a power.
std::size_t root_up(std::size_t n, int power) {
    std::size_t k = 1;
    const auto whole_power = [&] { return power == 2 ? k * k : k * k * k; };
    while (whole_power() < n) ++k;
    return k;
}

constexpr std::size_t kPaints = 12;

void add_paints(Scene& scene, float specular, float shininess) {
    for (std::size_t i = 0; i < kPaints; ++i)
        add_glossy(scene, "paint-" + std::to_string(i), 0.8f * hue(static_cast<double>(i) / kPaints, 0.6), specular, shininess);
}

} // namespace

// A cube of side 2 about the origin, its cells filled from below; a ball takes 0.35 of its cell's side as its radius, so none touch.
Scene make_spheres(const MakeValues& values) {
    Scene scene;
    const std::size_t n = values.count("n"), k = root_up(n, 3);
    const double cell = 2.0 / static_cast<double>(k);
    scene.environment.background = {0.02f, 0.03f, 0.05f};
    Camera& camera = add_camera(scene, {3.1, 2.6, 4.2}, {0, -0.15, 0}, 36);
    camera.hither = 0.01;
    add_point_light(scene, {5, 6, 4}, {0.8f, 0.78f, 0.72f}, Attenuation::none);
    add_point_light(scene, {-6, 2, 3}, {0.2f, 0.25f, 0.35f}, Attenuation::none);
    add_paints(scene, 0.3f, 40);
    const std::uint32_t floor = add_diffuse(scene, "floor", glm::vec3(0.4f));
    add_polygon(scene, {{-8, -1, 8}, {8, -1, 8}, {8, -1, -8}, {-8, -1, -8}}, floor);
    scene.objects.reserve(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t x = i % k, z = i / k % k, y = i / (k * k);
        const glm::dvec3 center = cell * (glm::dvec3(x, y, z) + 0.5) - 1.0;
        add_object(scene, Sphere{center, 0.35 * cell}, static_cast<std::uint32_t>((x + 5 * y + 3 * z) % kPaints));
    }
    return scene;
}

// Lights in a square grid at 1.4 m over the field, each of its own hue. Under the linear law a light gives Ip / (d + 1); n of them spread over
// the field share out about the brightness of two white lights at its middle, so that the picture keeps its exposure whatever n is.
Scene make_lights(const MakeValues& values) {
    Scene scene;
    const std::size_t n = values.count("n"), k = root_up(n, 2), count = values.count("objects"), side = root_up(count, 2);
    constexpr double kField = 8; // metres, the side of the square
    scene.environment.ambient = glm::vec3(0.03f);
    add_camera(scene, {0, 5.2, 8.6}, {0, 0, -0.2}, 42);
    add_paints(scene, 0.5f, 60);
    for (std::size_t i = 0; i < kPaints; ++i) scene.materials[i].diffuse = glm::vec3(0.7f); // white paint: the colours are the lights'
    const std::uint32_t floor = add_diffuse(scene, "floor", glm::vec3(0.6f));
    add_polygon(scene, {{-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5}}, floor);
    const double cell = kField / static_cast<double>(side), r = 0.32 * std::min(cell, 1.2);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 at((static_cast<double>(i % side) + 0.5) * cell - kField / 2, 0,
                            (static_cast<double>(i / side) + 0.5) * cell - kField / 2);
        const auto paint = static_cast<std::uint32_t>(i % kPaints);
        const std::array<Shape, 4> shapes = {Sphere{at + glm::dvec3(0, r, 0), r}, Cone{at, at + glm::dvec3(0, 2.5 * r, 0), r, 0, true},
                                             Torus{at + glm::dvec3(0, 0.3 * r, 0), {0, 1, 0}, 0.8 * r, 0.3 * r},
                                             Box{at - glm::dvec3(0.8 * r, 0, 0.8 * r), at + glm::dvec3(0.8 * r, 1.6 * r, 0.8 * r)}};
        add_object(scene, shapes[(i % side + 3 * (i / side)) % 4], paint);
    }
    const double pitch = kField / static_cast<double>(k);
    for (std::size_t i = 0; i < n; ++i) {
        const double x = (static_cast<double>(i % k) + 0.5) * pitch - kField / 2,
                     z = (static_cast<double>(i / k) + 0.5) * pitch - kField / 2;
        const double h = std::fmod(static_cast<double>(i) * 0.618033988749895, 1.0); // the golden section: neighbours differ, none repeat
        add_point_light(scene, {x, 1.4, z}, static_cast<float>(6.0 / static_cast<double>(n)) * hue(h, 0.85));
    }
    return scene;
}

} // namespace lightbench
