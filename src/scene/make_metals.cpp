// Metals of Cook-Torrance beside Phong: each metal a pair of columns, each roughness a row. Metres, the floor at y = 0.
#include "scene/make_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

// Reflectance at normal incidence, linear RGB: Akenine-Moller, Haines, Hoffman et al. 2018, "Real-Time Rendering", 4th ed., table 9.2, from
// the indices that Johnson and Christy 1972, "Optical Constants of the Noble Metals", measured (aluminium: Rakic 1995). Gold's red is 1.022
// there, outside of the gamut of sRGB; f0 must be below 1.
struct Metal {
    const char* name;
    glm::vec3 f0;
};
const std::array<Metal, 4>& metals() {
    static const std::array<Metal, 4> all = {{{"copper", {0.955f, 0.638f, 0.538f}},
                                              {"gold", {0.999f, 0.782f, 0.344f}},
                                              {"silver", {0.972f, 0.960f, 0.915f}},
                                              {"aluminium", {0.913f, 0.922f, 0.924f}}}};
    return all;
}

std::uint32_t add_metal(Scene& scene, const Metal& metal, std::size_t row, float m) {
    Material material;
    material.name = fmt::format("{}-{}", metal.name, row + 1);
    material.diffuse = glm::vec3(0), material.specular = glm::vec3(1);
    material.model = Model::cook_torrance;
    material.distribution = Distribution::beckmann;
    material.roughness = m;
    material.f0 = material.reflection = metal.f0;
    return add_material(scene, std::move(material));
}

// What Phong can say: the metal's color is diffuse, the highlight has the light's. The exponent of equal width is 2/m^2 - 2 (B. Karis 2013,
// "Specular BRDF Reference", with his a = m).
std::uint32_t add_painted(Scene& scene, const Metal& metal, std::size_t row, float m) {
    return add_glossy(scene, fmt::format("painted-{}-{}", metal.name, row + 1), 0.5f * metal.f0, 0.6f, std::max(2 / (m * m) - 2, 0.0f));
}

} // namespace

Scene make_metals(const MakeValues& values) {
    Scene scene;
    const std::size_t rows = values.count("rows"), columns = 2 * metals().size();
    const double ratio = values["roughest"] / values["smoothest"], half = 0.5 * double(columns - 1);
    for (std::size_t row = 0; row < rows; ++row) {
        const double m = values["smoothest"] * (rows > 1 ? std::pow(ratio, double(row) / double(rows - 1)) : 1);
        for (std::size_t i = 0; i < columns; ++i) {
            const auto add = i % 2 == 0 ? add_metal : add_painted;
            const double x = double(i) - half + (i % 2 == 0 ? 0.04 : -0.04);
            add_object(scene, Sphere{{x, 0.44, -double(row)}, 0.44}, add(scene, metals()[i / 2], row, static_cast<float>(m)));
        }
    }
    const double depth = double(rows);
    add_polygon(scene, {{-8, 0, 3}, {8, 0, 3}, {8, 0, -depth - 4}, {-8, 0, -depth - 4}}, add_diffuse(scene, "floor", glm::vec3(0.12f)));
    add_camera(scene, {0, 3.2 + 0.4 * depth, 7.5}, {0, 0.2, -0.5 * depth + 0.5}, 44);
    add_point_light(scene, {-5, 6, 4}, glm::vec3(7, 6.8f, 6.4f));
    add_point_light(scene, {5, 3, 3}, glm::vec3(1.6f, 1.9f, 2.4f));
    add_directional_light(scene, {0.3, -0.6, 1}, glm::vec3(0.3f)); // from behind: grazing angles, where all metals turn white
    scene.environment = {{0.02f, 0.025f, 0.035f}, glm::vec3(0.2f), {}};
    return scene;
}

} // namespace lightbench
