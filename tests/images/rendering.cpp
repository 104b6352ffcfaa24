#include "images/rendering.h"

#include "plan/facts.h"

#include <gtest/gtest.h>

namespace lightbench::testing {

gpu::Device& test_device() {
    static gpu::Device device = gpu::Device::open({"", true});
    return device;
}

Rendered render_scene(Scene scene, Request request) {
    CompleteResult completed = complete(scene, request);
    for (const Problem& p : completed.problems) ADD_FAILURE() << to_string(p);
    const View view = completed.completed.value().view;
    Facts facts = gather_facts(scene);
    add_view(facts, scene, view);
    const Plan plan = decide(facts, request, completed.completed->notes);
    RasterGeometry geometry = tessellate(scene, tessellation_for(plan, view));
    Renderer renderer(test_device(), scene, geometry, plan);
    RenderOutput output = renderer.render(view);
    for (const std::string& message : test_device().validation_messages()) ADD_FAILURE() << message;
    return {plan, view, std::move(geometry), std::move(output)};
}

Scene plane_scene(glm::dvec3 eye) {
    Scene scene;
    scene.name = "plane";
    Camera camera;
    camera.position = eye, camera.up = std::abs(eye.y) > std::abs(eye.z) ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    scene.cameras = {camera};
    Material material;
    material.diffuse = {0.7f, 0.5f, 0.3f};
    scene.materials = {material};
    Object plane;
    plane.shape = Polygon{{{-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}}, {}};
    scene.objects = {plane};
    return scene;
}

Light point_light(glm::dvec3 position, glm::vec3 intensity, Attenuation law) {
    Light light;
    light.position = position, light.intensity = intensity, light.attenuation = law;
    return light;
}

std::vector<Light> lights_of_every_kind() {
    Light sun, spot = point_light({2, 4, 0}, glm::vec3(2), Attenuation::linear);
    sun.type = LightType::directional, sun.direction = glm::normalize(glm::dvec3(-1, -1, -1)), sun.intensity = glm::vec3(0.3f);
    spot.type = LightType::spot, spot.direction = {0, -1, 0};
    return {point_light({-2, 4, 2}, {1, 0.8f, 0.6f}, Attenuation::linear), sun, spot,
            point_light({0, 3, 4}, glm::vec3(9), Attenuation::inverse_square)};
}

void scale_scene(Scene& scene, double s) {
    scene.transforms.push_back(glm::dmat4(glm::dmat3(s)));
    for (Object& o : scene.objects) o.transform = static_cast<std::uint32_t>(scene.transforms.size() - 1);
    for (Camera& c : scene.cameras) c.position *= s, c.target *= s;
    for (Light& l : scene.lights) {
        l.position *= s, l.d0 *= s;
        if (l.type == LightType::directional) continue;
        if (l.attenuation == Attenuation::linear) l.intensity *= float(s);
        if (l.attenuation == Attenuation::inverse_square) l.intensity *= float(s * s);
    }
}

Request radiance_request(Shading shading, glm::uvec2 size) {
    Request request;
    request.shading = shading, request.size = size, request.output = Output::radiance;
    return request;
}

glm::dvec3 pixel(const ImageF& image, unsigned x, unsigned y) {
    const float* p = image.at(x, y);
    return {p[0], p[1], p[2]};
}

} // namespace lightbench::testing
