// Metals of Cook-Torrance beside Phong on the shelves of a cabinet: each metal a pair of columns, each roughness a shelf, smooth ones above.
// Metres; the balls' centres are in the plane z = 0.
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

std::string name_on_shelf(const char* kind, const Metal& metal, std::size_t row) {
    return fmt::format("{}{}-{}", kind, metal.name, row + 1);
}

std::uint32_t add_metal(Scene& scene, const Metal& metal, std::size_t row, float m) {
    Material material;
    material.name = name_on_shelf("", metal, row);
    material.diffuse = glm::vec3(0), material.specular = glm::vec3(1);
    material.model = Model::cook_torrance;
    material.distribution = Distribution::beckmann;
    material.roughness = m;
    material.f0 = material.reflection = metal.f0;
    return add_material(scene, std::move(material));
}

// What Phong can say: the metal's color is diffuse, the highlight has the light's. The exponent of equal width is 2/m^2 - 2 between N and H
// (B. Karis 2013, "Specular BRDF Reference", with his a = m), a quarter of that between R and V (Fisher, Woo 1994, "R.E versus N.H Specular
// Highlights", Graphics Gems IV).
std::uint32_t add_painted(Scene& scene, const Metal& metal, std::size_t row, float m) {
    const float shininess = std::max(0.5f / (m * m) - 0.5f, 0.0f);
    return add_glossy(scene, name_on_shelf("painted-", metal, row), 0.32f * metal.f0, 0.45f, shininess);
}

void add_cabinet(Scene& scene, std::size_t rows) {
    const std::uint32_t wood = add_glossy(scene, "wood", {0.09f, 0.035f, 0.02f}, 0.15f, 30);
    for (std::size_t row = 0; row < rows; ++row)
        add_object(scene, Box{{-4.3, -double(row) - 0.52, -0.7}, {4.3, -double(row) - 0.44, 0.5}}, wood);
    const double bottom = -double(rows) + 0.4;
    add_polygon(scene, {{-4.3, bottom, -0.7}, {4.3, bottom, -0.7}, {4.3, 0.6, -0.7}, {-4.3, 0.6, -0.7}}, wood);
}

// Many lights in place of a surrounding: a metal shows nothing but what it mirrors. Lamps around the eye, two bars at the sides, and light
// along the shelves' backs: grazing angles, where all metals turn white.
void add_lamps(Scene& scene) {
    add_point_light(scene, {-3, 4, 6}, glm::vec3(3.4f, 3.3f, 3.1f));
    add_point_light(scene, {4, 2.5, 7}, glm::vec3(2.2f, 2.4f, 2.8f));
    for (const double y : {1.0, -1.0, -3.0, -5.0}) {
        add_directional_light(scene, {1, 0.15 * y, -0.35}, {0.26f, 0.22f, 0.17f});
        add_directional_light(scene, {-1, 0.15 * y, -0.35}, {0.16f, 0.2f, 0.26f});
    }
    add_directional_light(scene, {0, -1, 0.25}, glm::vec3(0.5f));
    add_directional_light(scene, {0, 1, -0.2}, {0.12f, 0.08f, 0.05f});
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
            add_object(scene, Sphere{{x, -double(row), 0}, 0.44}, add(scene, metals()[i / 2], row, static_cast<float>(m)));
        }
    }
    add_cabinet(scene, rows);
    add_lamps(scene);
    const double middle = 0.5 - 0.5 * double(rows), distance = 2.75 * std::max(double(rows) + 0.3, 4.7);
    add_camera(scene, {0, middle + 0.9, distance}, {0, middle, 0}, 21);
    scene.environment = {{0.02f, 0.025f, 0.035f}, glm::vec3(0.2f), {}};
    return scene;
}

} // namespace lightbench
