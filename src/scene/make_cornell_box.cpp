// The Cornell box as measured (Goral et al. 1984; the data published by Cornell's Program of Computer Graphics). Lengths in its own unit, the
// millimetre: 1 here is 1 mm. In: whether to add what methods without area lights need. Out: quads as polygons.
#include "scene/make_kinds.h"

#include <cmath>

namespace lightbench {
namespace {

const glm::vec3 kWhite(0.725f, 0.71f, 0.68f), kRed(0.63f, 0.065f, 0.05f), kGreen(0.14f, 0.45f, 0.091f);
const glm::vec3 kLampRadiance(17, 12, 4);
constexpr double kLampHeight = 548.7; // published with the ceiling's 548.8; a tenth below it, or the two would fight for every pixel

using Quad = std::vector<glm::dvec3>;

void add_walls(Scene& scene, std::uint32_t white, std::uint32_t red, std::uint32_t green) {
    add_polygon(scene, Quad{{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}}, white);
    add_polygon(scene, Quad{{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}}, white);
    add_polygon(scene, Quad{{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}}, white);
    add_polygon(scene, Quad{{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}}, green);
    // The four measured corners of the red wall do not lie in one plane (by 0.8 mm), and a polygon must: two triangles.
    add_polygon(scene, {{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}}, red);
    add_polygon(scene, {{552.8, 0, 0}, {556, 548.8, 559.2}, {556, 548.8, 0}}, red);
}

// A block without its bottom, which stands on the floor: the top as published, counter-clockwise from above, and its sides.
void add_block(Scene& scene, const Quad& top, std::uint32_t material) {
    add_polygon(scene, top, material);
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 a = top[i], b = top[(i + 1) % 4];
        add_polygon(scene, {{a.x, 0, a.z}, {b.x, 0, b.z}, b, a}, material);
    }
}

// The lamp of area A sends LA cos(theta) into the direction theta. Straight down, an inverse-square light of Ip / (4 pi d^2) gives the same
// irradiance over pi when Ip = 4 LA; as a wide spot that fades over its whole cone it spares the ceiling, as the lamp does.
void add_light_below_lamp(Scene& scene, double lamp_area) {
    Light& light = add_point_light(scene, {278, kLampHeight - 1, 279.5}, 4 * static_cast<float>(lamp_area) * kLampRadiance,
                                   Attenuation::inverse_square);
    light.type = LightType::spot;
    light.direction = {0, -1, 0};
    light.angle = radians_of(90);
    light.softness = 1;
}

// What the walls send each other, as one constant: in a closed diffuse room of surface S and mean reflectance rho the irradiance over pi that
// comes by way of at least one wall is LA rho / (S (1 - rho)) (the integrating sphere, Ulbricht 1900). The open front counts as black.
glm::vec3 ambient_of_box(double lamp_area) {
    const double side = 553;
    const glm::vec3 rho = (3.0f * kWhite + kRed + kGreen) / 6.0f;
    return static_cast<float>(lamp_area / (6 * side * side)) * kLampRadiance * rho / (1.0f - rho);
}

} // namespace

Scene make_cornell_box(const MakeValues& values) {
    Scene scene;
    scene.film = glm::uvec2(512);
    Camera& camera = add_camera(scene, {278, 273, -800}, {278, 273, 0}, 0);
    camera.fov = 2 * std::atan(0.025 / 2 / 0.035); // a film of 25 mm behind a focal length of 35 mm
    const std::uint32_t white = add_diffuse(scene, "white", kWhite), red = add_diffuse(scene, "red", kRed),
                        green = add_diffuse(scene, "green", kGreen), lamp = add_diffuse(scene, "lamp", glm::vec3(0));
    scene.materials[lamp].emission = kLampRadiance;
    scene.materials[lamp].two_sided = false; // it sends down only
    add_walls(scene, white, red, green);
    add_block(scene, {{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}, white);
    add_block(scene, {{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}, white);
    add_polygon(scene, {{343, kLampHeight, 227}, {343, kLampHeight, 332}, {213, kLampHeight, 332}, {213, kLampHeight, 227}}, lamp);
    const double lamp_area = 130 * 105;
    if (values.count("point_light") == 1) {
        add_light_below_lamp(scene, lamp_area);
        scene.environment.ambient = ambient_of_box(lamp_area);
    }
    return scene;
}

} // namespace lightbench
