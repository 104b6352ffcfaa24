// The builders behind the table of make.cpp, and the few verbs in which they speak. Inside the scene room only.
#pragma once

#include "scene/edit.h"
#include "scene/make.h"
#include "scene/transform.h"

#include <numbers>

namespace lightbench {

Scene make_sphereflake(const MakeValues&);
Scene make_primitives(const MakeValues&);
Scene make_cornell_box(const MakeValues&);
Scene make_corrugated(const MakeValues&);
Scene make_highlight(const MakeValues&);
Scene make_mach_band(const MakeValues&);
Scene make_crease(const MakeValues&);
Scene make_quads(const MakeValues&);
Scene make_spheres(const MakeValues&);
Scene make_mirrors(const MakeValues&);
Scene make_room(const MakeValues&);
Scene make_lights(const MakeValues&);
Scene make_mesh(const MakeValues&);
Scene make_teapot(const MakeValues&);
Scene make_metals(const MakeValues&);
Scene make_panes(const MakeValues&);

constexpr double radians_of(double degrees) {
    return degrees * (std::numbers::pi / 180);
}

// Each returns the index of what it added, or the thing itself to be adjusted.
std::uint32_t add_diffuse(Scene& scene, std::string name, glm::vec3 diffuse);
std::uint32_t add_glossy(Scene& scene, std::string name, glm::vec3 diffuse, float specular, float shininess);
Object& add_object(Scene& scene, Shape shape, std::uint32_t material);
Object& add_polygon(Scene& scene, std::vector<glm::dvec3> points, std::uint32_t material);
Object& add_mesh(Scene& scene, Mesh mesh, std::uint32_t material);
Light& add_point_light(Scene& scene, glm::dvec3 position, glm::vec3 intensity, Attenuation law = Attenuation::linear);
Light& add_directional_light(Scene& scene, glm::dvec3 direction, glm::vec3 intensity);
Camera& add_camera(Scene& scene, glm::dvec3 position, glm::dvec3 target, double fov_degrees);

std::uint32_t add_transform(Scene& scene, const TransformParts& placement);

void add_face(Mesh& mesh, std::initializer_list<std::uint32_t> corners);

// A colour of full saturation softened towards white: h in [0, 1) once around the wheel. Piecewise linear, so the same on every machine.
glm::vec3 hue(double h, double saturation = 0.7);

} // namespace lightbench
