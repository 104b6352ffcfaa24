// Translucent panes behind each other, a spiral of petals: all of them in every pixel of the middle, few in most others. Metres.
#include "scene/make_kinds.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace lightbench {
namespace {

constexpr std::size_t kColors = 24; // a petal each, in every turn
constexpr double kTurns = 3;        // of the spiral, from the front to the back
constexpr double kMiddle = 0.07;    // half the side of the square that all panes cover

// Counts to n in steps that hop about: a step near the golden section of n that has no divisor in common with it.
std::size_t hop(std::size_t n) {
    auto step = static_cast<std::size_t>(0.6180339887 * double(n)) + 1;
    while (std::gcd(step, n) != 1) ++step;
    return step;
}

void add_wall(Scene& scene) {
    const std::uint32_t wall = add_diffuse(scene, "wall", glm::vec3(0.1f, 0.11f, 0.17f));
    Texture checker;
    checker.mapping = Mapping::planar;
    checker.scale = glm::dvec2(21, 12);
    scene.materials[wall].texture = checker;
    add_polygon(scene, {{-5.25, -3, -2}, {5.25, -3, -2}, {5.25, 3, -2}, {-5.25, 3, -2}}, wall);
}

// `depth` from 0, the back, where petals are long, to 1, the front. Panes of one petal differ in depth only; each petal leans its own way.
void add_petal(Scene& scene, double depth, double tilt) {
    const double petal = std::floor(depth * kTurns * kColors), turns = petal / kColors;
    const double angle = 2 * std::numbers::pi * turns, lean = 2.399963 * petal; // the golden angle
    const double length = 1.6 - 1.05 * turns / kTurns, width = 0.42 * length, z = 1.2 * depth - 0.6;
    const auto corner = [&](double along, double across) {
        const double x = along * std::cos(angle) - across * std::sin(angle), y = along * std::sin(angle) + across * std::cos(angle);
        return glm::dvec3(x, y, z + tilt * (x * std::cos(lean) + y * std::sin(lean)));
    };
    add_polygon(scene,
                {corner(-kMiddle, -kMiddle), corner(kMiddle, -kMiddle), corner(0.75 * length, -width / 2), corner(length, 0),
                 corner(0.75 * length, width / 2), corner(kMiddle, kMiddle), corner(-kMiddle, kMiddle)},
                static_cast<std::uint32_t>(petal) % kColors);
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
    for (std::size_t i = 0, at = 0; i < n; ++i, at = (at + step) % n)
        add_petal(scene, n > 1 ? double(at) / double(n - 1) : 0.5, std::tan(radians_of(values["tilt"])));
    add_camera(scene, {0.3, 0.25, 7}, {0, 0, 0}, 26);
    add_directional_light(scene, {-0.2, -0.3, -1}, glm::vec3(0.8f));
    scene.environment = {{0.02f, 0.025f, 0.035f}, glm::vec3(0.3f), {}};
    return scene;
}

} // namespace lightbench
