// Builds the structure that the plan names, and uploads it with the primitives in its order.
#include "render/ray_scene.h"

#include "render/device_build.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <algorithm>
#include <iterator>

namespace lightbench {
namespace {

template <class T>
gpu::Buffer table(gpu::Device& device, RayScene& out, const char* name, const std::vector<T>& values, std::uint32_t bit) {
    if (values.empty()) return {};
    gpu::Buffer buffer = gpu::make_texel_buffer(device, name, values.size() * sizeof(T));
    gpu::upload(device, buffer, std::as_bytes(std::span(values)));
    if (!buffer.as_texel()) out.fetch_storage |= bit;
    return buffer;
}

AccelRequest request_of(const Plan& plan) {
    AccelRequest request;
    request.accel = static_cast<Accel>(plan.accel);
    request.leaf = plan.accel_parameters.leaf;
    for (std::size_t i = 0; i < 3; ++i) request.cells[i] = plan.accel_parameters.cells[static_cast<int>(i)];
    request.density = plan.accel_parameters.density;
    request.depth = plan.accel_parameters.depth;
    return request;
}

std::uint32_t effects_of(const RayPrimitives& primitives, const Plan& plan) {
    static constexpr std::uint32_t kShapes[] = {RAY_BOXES, RAY_BALLS, RAY_CONES, RAY_TORI}; // by kShape...
    std::uint32_t effects = primitives.spheres.empty() ? 0 : RAY_SPHERES;
    for (const gpu_layout::RayShape& shape : primitives.shapes) effects |= kShapes[shape.kind];
    if (primitives.triangles.empty()) return effects;
    effects |= RAY_TRIANGLES;
    if (plan.has("normals")) effects |= RAY_SMOOTH;
    if (plan.has("detail")) effects |= RAY_UV;
    return effects;
}

bool refracts(const Scene& scene, const RasterGeometry& geometry, std::uint32_t surface) {
    return glm::any(glm::greaterThan(scene.materials[geometry.surfaces[surface].material].transmission, glm::vec3(0)));
}

// Only what has a material that refracts.
RayPrimitives media_of(const Scene& scene, const RasterGeometry& geometry, const RayPrimitives& all) {
    const auto is_medium = [&](const auto& primitive) { return refracts(scene, geometry, primitive.surface); };
    RayPrimitives media;
    std::ranges::copy_if(all.triangles, std::back_inserter(media.triangles), is_medium);
    std::ranges::copy_if(all.spheres, std::back_inserter(media.spheres), is_medium);
    std::ranges::copy_if(all.shapes, std::back_inserter(media.shapes), is_medium);
    return media;
}

void note(RayScene& out, const gpu::Buffer& buffer, std::uint32_t bit) {
    if (buffer && !buffer.as_texel()) out.fetch_storage |= bit;
}

void build_there(gpu::Device& device, RayScene& out, const RayPrimitives& primitives, std::uint32_t leaf) {
    DeviceBuilder builder(device);
    builder.warm_up(primitives);
    DeviceTree tree = builder.build(primitives, leaf);
    out.nodes = std::move(tree.nodes), out.narrow = std::move(tree.narrow);
    out.triangles = std::move(tree.triangles), out.spheres = std::move(tree.spheres), out.shapes = std::move(tree.shapes);
    note(out, out.nodes, FETCH_NODES), note(out, out.narrow, FETCH_NARROW);
    note(out, out.triangles, FETCH_TRIANGLES), note(out, out.spheres, FETCH_SPHERES), note(out, out.shapes, FETCH_SHAPES);
    out.accel = std::move(tree.accel);
    out.structure_bytes = out.nodes.size() + out.narrow.size();
}

void upload_built_here(gpu::Device& device, RayScene& out, const RayPrimitives& primitives) {
    if (!out.accel.narrow.empty()) prepend_planes(out.accel);
    out.structure_bytes = out.accel.bytes();
    out.nodes = table(device, out, "nodes", out.accel.nodes, FETCH_NODES);
    out.narrow = table(device, out, "narrow", out.accel.narrow, FETCH_NARROW);
    out.triangles = table(device, out, "triangles", primitives.triangles, FETCH_TRIANGLES);
    out.spheres = table(device, out, "spheres", primitives.spheres, FETCH_SPHERES);
    out.shapes = table(device, out, "shapes", primitives.shapes, FETCH_SHAPES);
    out.accel.nodes = {}, out.accel.narrow = {};
}

// For shaders, which order hits by that. Once the host has built its structure, which goes by the numbers; the device's goes by places.
void mark_media(const Scene& scene, const RasterGeometry& geometry, RayPrimitives& primitives) {
    const auto mark = [&](auto& primitive) {
        if (refracts(scene, geometry, primitive.surface)) primitive.number |= gpu_layout::kRefracts;
    };
    std::ranges::for_each(primitives.triangles, mark);
    std::ranges::for_each(primitives.spheres, mark);
    std::ranges::for_each(primitives.shapes, mark);
}

} // namespace

void prepend_planes(AccelTables& tables) {
    const auto words = [](const glm::vec3& v) { return glm::uvec4(glm::floatBitsToUint(v), 0); };
    tables.narrow.insert(tables.narrow.begin(), {words(tables.narrow_origin), words(tables.narrow_step)});
}

RayScene upload_rays(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan) {
    RayPrimitives primitives = ray_primitives(scene, geometry);
    for (const Camera& camera : scene.cameras) // a turntable keeps the distance from the target, which may lie anywhere in the scene
        primitives.reach = std::max(primitives.reach, glm::length(geometry.frame.from_world(camera.position)) + 2 * geometry.frame.radius);
    RayScene out;
    if (plan.ray_effects & RAY_REFRACTED) out.media = media_of(scene, geometry, primitives);
    // A tree of one primitive, or of none, has nothing to sort.
    const bool there = plan.accel == Structure::bvh && plan.accel_parameters.builder == TreeBuilder::device && has_tree(primitives);
    if (!there) out.accel = build_accel(primitives, request_of(plan));
    if (plan.ray_effects & RAY_REFRACTED) mark_media(scene, geometry, primitives);
    if (there)
        build_there(device, out, primitives, plan.accel_parameters.leaf);
    else
        upload_built_here(device, out, primitives);
    out.effects = effects_of(primitives, plan);
    out.stack = std::max(out.accel.stack, 2u);
    if (out.effects & (RAY_SMOOTH | RAY_UV)) out.corners = table(device, out, "corners", primitives.corners, FETCH_CORNERS);
    out.triangle_count = static_cast<std::uint32_t>(primitives.triangles.size());
    out.sphere_count = static_cast<std::uint32_t>(primitives.spheres.size());
    out.shape_count = static_cast<std::uint32_t>(primitives.shapes.size());
    const std::size_t counts[] = {primitives.triangles.size(), primitives.spheres.size(), primitives.shapes.size()};
    for (std::size_t type = 0; type < 3; ++type) {
        out.loose |= out.accel.loose[type] << (4 * type);
        if (counts[type] > out.accel.loose[type]) out.loose |= 1u << (12 + type);
    }
    return out;
}

} // namespace lightbench
