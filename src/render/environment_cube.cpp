// Each cube is a scene of its own, planned and drawn like any other: a square camera of 90 degrees, turned to the six sides.
#include "render/environment_cube.h"

#include "gpu/check.h"
#include "render/render.h"
#include "shared/effects.h"

#include <numbers>

namespace lightbench {
namespace {

struct Side {
    glm::dvec3 forward, up;
};

// Each face upright, as seen from within; +Y and -Y continue -Z upwards and downwards (lib/environment.glsl, cube_face).
constexpr Side kSides[6] = {{{1, 0, 0}, {0, 1, 0}},   {{-1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, 1}},
                            {{0, -1, 0}, {0, 0, -1}}, {{0, 0, 1}, {0, 1, 0}},  {{0, 0, -1}, {0, 1, 0}}};

View view_towards(const Side& side, const EnvironmentCube& cube, double near) {
    View view;
    view.eye = cube.center;
    const glm::dmat3 view_from_world = glm::transpose(glm::dmat3(glm::cross(side.forward, side.up), side.up, -side.forward));
    view.view_from_world = glm::dmat4(view_from_world);
    view.view_from_world[3] = glm::dvec4(-(view_from_world * cube.center), 1);
    view.near = near, view.fov = std::numbers::pi / 2, view.size = glm::uvec2(cube.size);
    view.clip_from_view = perspective(view.fov, 1, near);
    return view;
}

// As complete() places it: no precision is lost by it.
double near_plane(const Scene& scene) {
    const Bounds bounds = bounds_of(scene);
    const double radius = bounds.empty() ? 0 : glm::length(bounds.max - bounds.min) / 2;
    return 1e-6 * (radius > 0 ? radius : 1);
}

// Mirrors are seen in mirrors without what they mirror: one bounce.
Scene without_mirrors(const Scene& scene) {
    Scene plain = scene;
    for (Material& material : plain.materials) material.environment = 0;
    return plain;
}

CubeFaces render_faces(gpu::Device& device, const Scene& scene, const Plan& plan, const EnvironmentCube& cube, double& milliseconds) {
    Request request;
    request.shading = plan.shading, request.subdivide = plan.subdivide, request.output = Output::radiance;
    request.size = glm::uvec2(cube.size), request.spp = 4;
    const double near = near_plane(scene);
    Facts facts = gather_facts(scene);
    const TessellationRequest fineness = tessellation_for(decide(facts, request), view_towards(kSides[0], cube, near));
    const RasterGeometry geometry = tessellate(scene, fineness);
    add_geometry(facts, geometry);
    Renderer renderer(device, scene, geometry, decide(facts, request));
    CubeFaces faces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        RenderOutput output = renderer.render(view_towards(kSides[i], cube, near));
        milliseconds += output.device_milliseconds;
        faces[i] = std::move(output.radiance.value());
    }
    return faces;
}

} // namespace

EnvironmentViews render_environment_cubes(gpu::Device& device, const Scene& scene, const Plan& plan) {
    EnvironmentViews views;
    CHECK(plan.cubes.cubes.empty() == !(plan.effects & EFFECT_RENDERED_CUBE), "a plan without a view");
    if (plan.cubes.cubes.empty()) return views;
    Scene others = without_mirrors(scene);
    for (const EnvironmentCube& cube : plan.cubes.cubes) {
        others.objects = scene.objects;
        others.objects.erase(others.objects.begin() + cube.object);
        views.cubes.push_back(render_faces(device, others, plan, cube, views.milliseconds));
    }
    return views;
}

} // namespace lightbench
