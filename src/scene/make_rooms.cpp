// Scenes seen from inside: a corridor between mirrors, and a closed diffuse room. Metres, the floor at y = 0.
#include "scene/make_kinds.h"

#include <algorithm>
#include <array>

namespace lightbench {
namespace {

// The six sides of the box [lo, hi], facing inwards, in the order -X +X -Y +Y -Z +Z.
void add_inner_walls(Scene& scene, const glm::dvec3& lo, const glm::dvec3& hi, const std::array<std::uint32_t, 6>& material) {
    add_polygon(scene, {{lo.x, lo.y, hi.z}, {lo.x, lo.y, lo.z}, {lo.x, hi.y, lo.z}, {lo.x, hi.y, hi.z}}, material[0]);
    add_polygon(scene, {{hi.x, lo.y, lo.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {hi.x, hi.y, lo.z}}, material[1]);
    add_polygon(scene, {{lo.x, lo.y, lo.z}, {lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, lo.y, lo.z}}, material[2]);
    add_polygon(scene, {{lo.x, hi.y, lo.z}, {hi.x, hi.y, lo.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z}}, material[3]);
    add_polygon(scene, {{lo.x, lo.y, lo.z}, {hi.x, lo.y, lo.z}, {hi.x, hi.y, lo.z}, {lo.x, hi.y, lo.z}}, material[4]);
    add_polygon(scene, {{hi.x, lo.y, hi.z}, {lo.x, lo.y, hi.z}, {lo.x, hi.y, hi.z}, {hi.x, hi.y, hi.z}}, material[5]);
}

// A lamp of 1 m x 1 m at height y, facing down, and a point light below it for methods without area lights (Ip = 4 L A, as for the Cornell box).
void add_lamp(Scene& scene, double x, double y, double z, glm::vec3 radiance) {
    const std::uint32_t lamp = add_diffuse(scene, "lamp", glm::vec3(0));
    scene.materials[lamp].emission = radiance;
    add_polygon(scene, {{x - 0.5, y, z - 0.5}, {x + 0.5, y, z - 0.5}, {x + 0.5, y, z + 0.5}, {x - 0.5, y, z + 0.5}}, lamp);
    add_point_light(scene, {x, y - 0.25, z}, 4.0f * radiance, Attenuation::inverse_square);
}

void add_furniture(Scene& scene) {
    const std::uint32_t wood = add_diffuse(scene, "wood", {0.5f, 0.32f, 0.18f}), blue = add_diffuse(scene, "book", {0.15f, 0.25f, 0.5f});
    add_object(scene, Box{{-0.9, 0.7, -1.6}, {0.9, 0.76, -0.6}}, wood);
    for (const double x : {-0.85, 0.79})
        for (const double z : {-1.55, -0.71}) add_object(scene, Box{{x, 0, z}, {x + 0.06, 0.7, z + 0.06}}, wood);
    add_object(scene, Box{{-0.5, 0.76, -1.3}, {-0.2, 0.84, -0.9}}, blue);
    add_object(scene, Box{{1.55, 0, -2}, {1.99, 1.8, -0.8}}, wood);
}

} // namespace

// Two mirrors along the corridor, one metre and a half to either side; posts of all colours down the middle.
Scene make_mirrors(const MakeValues& values) {
    Scene scene;
    const double length = values["length"];
    scene.environment.ambient = glm::vec3(0.1f);
    add_camera(scene, {0.9, 1.5, 0.8}, {-0.35, 1.0, -2.5}, 60);
    const auto floor = add_diffuse(scene, "floor", {0.35f, 0.3f, 0.25f}), ceiling = add_diffuse(scene, "ceiling", {0.7f, 0.7f, 0.75f}),
               ends = add_diffuse(scene, "end", {0.5f, 0.45f, 0.4f}), mirror = add_diffuse(scene, "mirror", glm::vec3(0.02f));
    scene.materials[mirror].reflection = glm::vec3(static_cast<float>(values["reflection"]));
    add_inner_walls(scene, {-1.5, 0, -length}, {1.5, 2.6, 1}, {mirror, mirror, floor, ceiling, ends, ends});
    const auto posts = static_cast<std::size_t>(std::clamp(length / 1.5, 1.0, 64.0));
    for (std::size_t i = 0; i < posts; ++i) {
        const double z = -1.5 - static_cast<double>(i) * 1.5;
        if (z < 0.3 - length) break;
        const auto paint =
            add_glossy(scene, "post-" + std::to_string(i), 0.8f * hue(static_cast<double>(i) / static_cast<double>(posts)), 0.3f, 40);
        add_object(scene, Cylinder{{0, 0, z}, {0, 0.9, z}, 0.12, true}, paint);
        add_object(scene, Sphere{{0, 1.1, z}, 0.2}, paint);
        if (i % 2 == 0) add_point_light(scene, {0, 2.3, z + 0.6}, glm::vec3(1.1f, 1.0f, 0.85f));
    }
    return scene;
}

// Closed and diffuse: the rows of its form factors sum to one. Walls and ceiling are seen from inside only by way of their winding; they
// are two-sided all the same, so that a camera moved outside sees them too.
Scene make_room(const MakeValues& values) {
    Scene scene;
    const auto reflectance = static_cast<float>(values["reflectance"]);
    scene.environment.ambient = glm::vec3(0.12f);
    add_camera(scene, {-1.2, 1.55, 2.3}, {0.25, 0.95, -1.2}, 65);
    const auto white = add_diffuse(scene, "white", glm::vec3(reflectance)),
               warm = add_diffuse(scene, "warm", reflectance * glm::vec3(1, 0.55f, 0.35f)),
               cool = add_diffuse(scene, "cool", reflectance * glm::vec3(0.4f, 0.65f, 1)),
               floor = add_diffuse(scene, "floor", reflectance * glm::vec3(0.7f, 0.6f, 0.5f));
    for (Material& material : scene.materials) material.two_sided = true;
    add_inner_walls(scene, {-2, 0, -2.5}, {2, 2.5, 2.5}, {warm, cool, floor, white, white, white});
    add_lamp(scene, 0, 2.49, 0, {6, 5.6, 5});
    if (values.count("furnished") == 1) add_furniture(scene);
    return scene;
}

} // namespace lightbench
