#include "app/probe_tree.h"

#include "app/prepare.h"
#include "scene/surfaces.h"
#include "shared/rays.h"

namespace lightbench {
namespace {

Scene as_drawn(Scene scene) {
    for (Material& m : scene.materials)
        m.opacity = straight_opacity(m), m.transmission = glm::vec3(0), m.reflection = glm::vec3(0), m.fresnel = false;
    return scene;
}

} // namespace

Probe probe_tree(gpu::Device& device, const Scene& scene, Request request, glm::uvec2 pixel) {
    const bool drawn = request.method == Method::raster;
    Scene traced = drawn ? as_drawn(scene) : scene;
    request.method = Method::raytrace, request.shading = Shading::phong;
    Prepared prepared = prepare(traced, request);
    if (drawn) prepared.plan.ray_effects &= ~(RAY_SHADOWS | RAY_CLEAR_SHADOWS | RAY_CUTOFF);
    Probe tree = probe_pixel(device, traced, prepared.geometry, prepared.plan, prepared.view, pixel);
    for (ProbedRay& ray : tree.rays)
        for (ProbedStop& stop : ray.stops)
            if (drawn && stop.branch != "straight") stop.reason = "the rasteriser sends none";
    return tree;
}

} // namespace lightbench
