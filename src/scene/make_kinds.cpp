// The verbs that builders of procedural scenes share.
#include "scene/make_kinds.h"

#include <algorithm>
#include <cmath>

namespace lightbench {

std::uint32_t add_diffuse(Scene& scene, std::string name, glm::vec3 diffuse) {
    Material m;
    m.name = std::move(name);
    m.diffuse = diffuse;
    return add_material(scene, std::move(m));
}

std::uint32_t add_glossy(Scene& scene, std::string name, glm::vec3 diffuse, float specular, float shininess) {
    const std::uint32_t index = add_diffuse(scene, std::move(name), diffuse);
    scene.materials[index].specular = glm::vec3(specular);
    scene.materials[index].shininess = shininess;
    return index;
}

Object& add_object(Scene& scene, Shape shape, std::uint32_t material) {
    Object object;
    object.shape = std::move(shape);
    object.material = material;
    return scene.objects.emplace_back(std::move(object));
}

Object& add_polygon(Scene& scene, std::vector<glm::dvec3> points, std::uint32_t material) {
    return add_object(scene, Polygon{std::move(points), {}}, material);
}

Object& add_mesh(Scene& scene, Mesh mesh, std::uint32_t material) {
    scene.meshes.push_back(std::move(mesh));
    return add_object(scene, MeshUse{static_cast<std::uint32_t>(scene.meshes.size() - 1)}, material);
}

Light& add_point_light(Scene& scene, glm::dvec3 position, glm::vec3 intensity, Attenuation law) {
    Light light;
    light.position = position;
    light.intensity = intensity;
    light.attenuation = law;
    return scene.lights.emplace_back(light);
}

Light& add_directional_light(Scene& scene, glm::dvec3 direction, glm::vec3 intensity) {
    Light light;
    light.type = LightType::directional;
    light.direction = glm::normalize(direction);
    light.intensity = intensity;
    return scene.lights.emplace_back(light);
}

Camera& add_camera(Scene& scene, glm::dvec3 position, glm::dvec3 target, double fov_degrees) {
    Camera camera;
    camera.name = scene.cameras.empty() ? "main" : "camera-" + std::to_string(scene.cameras.size() + 1);
    camera.position = position;
    camera.target = target;
    camera.fov = radians_of(fov_degrees);
    return scene.cameras.emplace_back(camera);
}

std::uint32_t add_transform(Scene& scene, const TransformParts& placement) {
    scene.transforms.push_back(world_from_object(placement));
    return static_cast<std::uint32_t>(scene.transforms.size() - 1);
}

void add_face(Mesh& mesh, std::initializer_list<std::uint32_t> corners) {
    if (mesh.face_starts.empty()) mesh.face_starts.push_back(0);
    mesh.corners.insert(mesh.corners.end(), corners);
    mesh.face_starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
}

glm::vec3 hue(double h, double saturation) {
    // Smith 1978, "Color Gamut Transform Pairs", the hexcone with value 1: each channel is a trapezoid, a third of the wheel apart.
    const auto channel = [&](double offset) {
        const double t = std::fmod(h + offset, 1.0) * 6;
        const double full = std::min(1.0, std::max(0.0, std::fabs(t - 3) - 1));
        return static_cast<float>(1 - saturation * (1 - full));
    };
    return {channel(0), channel(2.0 / 3), channel(1.0 / 3)};
}

} // namespace lightbench
