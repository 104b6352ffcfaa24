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
