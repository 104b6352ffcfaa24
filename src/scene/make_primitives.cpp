// One of each shape on a chequered floor, under a light of each type. Metres, the floor at y = 0.
#include "scene/make_kinds.h"

#include <array>
#include <cmath>

namespace lightbench {
namespace {

// A five-pointed star that stands on its two lower points: a concave polygon.
std::vector<glm::dvec3> star(const glm::dvec3& center, double outer) {
    std::vector<glm::dvec3> points;
    const double inner = outer * 0.381966; // the golden section squared: then the edges line up, as in a pentagram
    for (int i = 0; i < 10; ++i) {
        const double a = radians_of(90 + 36 * i), r = i % 2 == 0 ? outer : inner;
        points.push_back(center + glm::dvec3(r * std::cos(a), r * std::sin(a), 0));
    }
    return points;
}

// An octahedron, as the smallest mesh that is clearly none of the other shapes.
Mesh octahedron(const glm::dvec3& center, double radius) {
    Mesh mesh;
    mesh.name = "octahedron";
    for (const glm::dvec3& d : {glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
        mesh.positions.emplace_back(center + radius * d);
    for (const std::uint32_t y : {2u, 3u}) {
        const std::array<std::uint32_t, 4> ring = y == 2 ? std::array{4u, 0u, 5u, 1u} : std::array{1u, 5u, 0u, 4u};
        for (std::size_t i = 0; i < 4; ++i) add_face(mesh, {ring[i], ring[(i + 1) % 4], y});
    }
    return mesh;
}

void add_floor(Scene& scene) {
    const std::uint32_t light = add_diffuse(scene, "tile-light", glm::vec3(0.55f, 0.52f, 0.47f)),
                        dark = add_diffuse(scene, "tile-dark", glm::vec3(0.16f, 0.17f, 0.2f));
    for (int i = -6; i < 6; ++i)
        for (int k = -5; k < 4; ++k)
            add_polygon(scene, {{i, 0, k + 1}, {i + 1, 0, k + 1}, {i + 1, 0, k}, {i, 0, k}}, (i + k) % 2 == 0 ? light : dark);
}

void add_shapes(Scene& scene) {
    const auto paint = [&](const char* name, double h, float specular, float shininess) {
        return add_glossy(scene, name, 0.75f * hue(h, 0.8), specular, shininess);
    };
    add_object(scene, Sphere{{-2.4, 0.6, -0.9}, 0.6}, paint("sphere", 0.0, 0.6f, 80));
    add_object(scene, Cylinder{{-0.8, 0, -1.3}, {-0.8, 1.3, -1.3}, 0.45, true}, paint("cylinder", 0.09, 0.3f, 30));
    add_object(scene, Cone{{0.8, 0, -1.3}, {0.8, 1.5, -1.3}, 0.6, 0, true}, paint("cone", 0.16, 0.4f, 40));
    add_object(scene, Box{glm::dvec3(-0.5), glm::dvec3(0.5)}, paint("box", 0.33, 0.2f, 20)).transform =
        add_transform(scene, {{2.4, 0.5, -0.9}, {0, 35, 0}, glm::dvec3(1)});
    add_object(scene, Torus{{-1.5, 0.22, 0.7}, {0, 1, 0}, 0.55, 0.22}, paint("torus", 0.5, 0.7f, 100));
    add_mesh(scene, octahedron({0, 0.55, 0.4}, 0.55), paint("mesh", 0.62, 0.4f, 50));
    const std::uint32_t star_paint = paint("polygon", 0.86, 0.2f, 20);
    add_polygon(scene, star({1.5, 0.6 * std::cos(radians_of(36)), 0.7}, 0.6), star_paint);
}

} // namespace

Scene make_primitives(const MakeValues&) {
    Scene scene;
    scene.environment = {{0.015f, 0.02f, 0.035f}, glm::vec3(0.12f), {}};
    add_camera(scene, {0.6, 2.9, 6.2}, {0, 0.45, -0.4}, 36);
    add_floor(scene);
    add_shapes(scene);
    add_point_light(scene, {-3.5, 4.5, 3.5}, glm::vec3(4.6f, 4.3f, 3.8f));
    add_directional_light(scene, {-1, -0.9, -0.5}, {0.1f, 0.14f, 0.25f});
    Light& spot = add_point_light(scene, {3, 5, 1}, glm::vec3(140, 120, 90), Attenuation::inverse_square);
    spot.type = LightType::spot;
    spot.direction = glm::normalize(glm::dvec3(-0.6, -1, -0.35));
    spot.angle = radians_of(24);
    spot.softness = 0.4;
    return scene;
}

} // namespace lightbench
