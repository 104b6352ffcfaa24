// The sphereflake: Haines 1987, "A Proposal for Standard Graphics Environments", the data base `balls`. In: the depth. Out: balls, ground, lights.
#include "scene/make_kinds.h"

#include <array>
#include <cmath>

namespace lightbench {
namespace {

using Directions = std::array<glm::dvec3, 9>;

// Where the nine children of a ball that grows along +Z touch it: three on its upper side (z^2 = 2/3), six on its equator, the azimuths
// evenly spread, the first of them 45 and 15 degrees.
Directions children_of_upright_ball() {
    Directions d;
    for (int i = 0; i < 3; ++i) {
        const double a = radians_of(45 + 120 * i);
        d[static_cast<std::size_t>(i)] = {std::cos(a) / std::sqrt(3.0), std::sin(a) / std::sqrt(3.0), std::sqrt(2.0 / 3)};
    }
    for (int i = 0; i < 6; ++i) {
        const double a = radians_of(15 + 60 * i);
        d[static_cast<std::size_t>(3 + i)] = {std::cos(a), std::sin(a), 0};
    }
    return d;
}

// Turns v by the smallest rotation that takes +Z to the unit vector d (Rodrigues 1840, with z x d as the axis and d.z as the cosine).
// Opposite to +Z the axis is free; Haines turns about Y. Rounding keeps such a direction within 1e-14 of -Z, and no other one of the set comes
// nearer than 1e-5 (test Make.SphereflakeHasNoNearlyDownwardChild), hence the 1e-10.
glm::dvec3 turn_from_z(const glm::dvec3& d, const glm::dvec3& v) {
    const double off_axis = d.x * d.x + d.y * d.y;
    if (d.z < 0 && off_axis < 1e-20) return {-v.x, v.y, -v.z};
    const double one_plus_cosine = d.z < 0 ? off_axis / (1 - d.z) : 1 + d.z; // no difference of equals near -Z
    const glm::dvec3 axis(-d.y, d.x, 0);
    const glm::dvec3 once = glm::cross(axis, v);
    return v + once + glm::cross(axis, once) / one_plus_cosine;
}

void add_ball(Scene& scene, const Directions& upright, const glm::dvec3& center, double radius, const glm::dvec3& growth,
              std::size_t depth) {
    add_object(scene, Sphere{center, radius}, 1);
    if (depth == 0) return;
    for (const glm::dvec3& child : upright) {
        const glm::dvec3 d = turn_from_z(growth, child);
        add_ball(scene, upright, center + d * (radius + radius / 3), radius / 3, d, depth - 1);
    }
}

} // namespace

// The numbers are those of the data base: a camera in the first octant with Z up, three white lights of 1/sqrt(3), a tilted sky blue.
Scene make_sphereflake(const MakeValues& values) {
    Scene scene;
    scene.film = glm::uvec2(512);
    scene.environment.background = {0.078f, 0.361f, 0.753f};
    Camera& camera = add_camera(scene, {2.1, 1.3, 1.7}, glm::dvec3(0), 45);
    camera.up = {0, 0, 1};
    camera.hither = 0.01;
    const glm::vec3 white(static_cast<float>(1 / std::sqrt(3.0)));
    for (const glm::dvec3& p : {glm::dvec3(4, 3, 2), glm::dvec3(1, -4, 4), glm::dvec3(-3, 1, 5)})
        add_point_light(scene, p, white, Attenuation::none);
    add_diffuse(scene, "ground", 0.8f * glm::vec3(1, 0.75f, 0.33f));
    add_glossy(scene, "ball", 0.5f * glm::vec3(1, 0.9f, 0.7f), 0.5f, 3.0827f);
    add_polygon(scene, {{12, 12, -0.5}, {-12, 12, -0.5}, {-12, -12, -0.5}, {12, -12, -0.5}}, 0);
    add_ball(scene, children_of_upright_ball(), glm::dvec3(0), 0.5, {0, 0, 1}, values.count("depth"));
    return scene;
}

} // namespace lightbench
