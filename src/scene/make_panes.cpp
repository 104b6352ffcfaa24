// Translucent panes behind each other, all of them in every pixel of the middle: what transparency has to sort. Metres.
#include "scene/make_kinds.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace lightbench {
namespace {

constexpr std::size_t kColors = 16;

// Counts to n in steps that hop about: a step near the golden section of n that has no divisor in common with it.
std::size_t hop(std::size_t n) {
    auto step = static_cast<std::size_t>(0.6180339887 * double(n)) + 1;
    while (std::gcd(step, n) != 1) ++step;
    return step;
}

void add_wall(Scene& scene) {
    const std::uint32_t wall = add_diffuse(scene, "wall", glm::vec3(0.9f));
    Texture checker;
    checker.mapping = Mapping::planar;
    checker.scale = glm::dvec2(8);
    scene.materials[wall].texture = checker;
    add_polygon(scene, {{-2, -2, -2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, -2}}, wall);
}

} // namespace

Scene make_panes(const MakeValues& values) {
    Scene scene;
    const std::size_t n = values.count("n"), step = hop(n);
    const auto opacity = static_cast<float>(values["opacity"]);
    for (std::size_t i = 0; i < kColors; ++i) {
        const glm::vec3 color = hue(double(i) / kColors);
        const std::uint32_t glass = add_diffuse(scene, fmt::format("glass-{}", i + 1), color);
        scene.materials[glass].opacity = opacity * (0.5f + 0.5f * color);
    }
    add_wall(scene);
    const double tilt = std::tan(radians_of(values["tilt"]));
    for (std::size_t i = 0, at = 0; i < n; ++i, at = (at + step) % n) {
        const double z = n > 1 ? 3 * double(at) / double(n - 1) - 1.5 : 0, turn = 2.399963 * double(at); // the golden angle
        const auto corner = [&](double x, double y) { return glm::dvec3(x, y, z + tilt * (x * std::cos(turn) + y * std::sin(turn))); };
        add_polygon(scene, {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, static_cast<std::uint32_t>(at % kColors));
    }
    add_camera(scene, {0.8, 0.6, 7}, {0, 0, 0}, 30);
    add_directional_light(scene, {-0.2, -0.3, -1}, glm::vec3(0.8f));
    scene.environment = {{0.02f, 0.025f, 0.035f}, glm::vec3(0.3f), {}};
    return scene;
}

} // namespace lightbench
