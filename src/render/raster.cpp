// Pipelines and passes of the rasteriser.
#include "render/raster.h"

#include "render/cull.h"
#include "render/shaders.h"
#include "shared/effects.h"
#include "shared/layouts.h"

namespace lightbench {
namespace {

using vk::ImageUsageFlagBits;
constexpr vk::Format kRadiance = vk::Format::eR32G32B32A32Sfloat, kDepth = vk::Format::eD32Sfloat;

std::uint32_t shading_constant(Shading shading) {
    return shading == Shading::flat ? SHADING_FLAT : shading == Shading::gouraud ? SHADING_GOURAUD : SHADING_PHONG;
}

gpu::Constants constants_of(const Plan& plan, const GpuScene& scene, const RasterVariant& variant) {
    return {{CONSTANT_EFFECTS, variant.effects},
            {CONSTANT_SHADING, shading_constant(plan.shading)},
            {CONSTANT_OUTPUT, variant.output},
            {CONSTANT_LIGHT_COUNT, plan.light_count},
            {CONSTANT_FETCH_STORAGE, scene.fetch_storage}};
}

bool shades_points(const Plan& plan, const RasterVariant& variant) {
    return plan.shading != Shading::phong && variant.output != OUTPUT_DEPTH && variant.output != OUTPUT_OBJECT;
}

// The streams that this variant's vertex stage reads, in the order of binding.
std::vector<gpu::VertexLayout> vertex_layouts(const Plan& plan, const RasterVariant& variant) {
    using F = vk::Format;
    std::vector<gpu::VertexLayout> layouts{{16, {{0, F::eR32G32B32Sfloat, 0}, {1, F::eR32Uint, 12}}}};
    if (variant.output == OUTPUT_DEPTH || variant.output == OUTPUT_OBJECT) return layouts;
    if (plan.shading == Shading::phong) layouts.push_back({16, {{2, F::eR32G32B32Sfloat, 0}, {3, F::eR32Uint, 12}}});
    if (plan.shading == Shading::gouraud && variant.effects & EFFECT_TWO_SIDED)
        layouts.push_back({32, {{4, F::eR32G32B32Sfloat, 0}, {5, F::eR32G32B32Sfloat, 16}}});
    else if (plan.shading == Shading::gouraud)
        layouts.push_back({16, {{4, F::eR32G32B32Sfloat, 0}}});
    return layouts;
}

std::vector<gpu::Buffer*> vertex_buffers(GpuScene& scene, const Plan& plan, const RasterVariant& variant) {
    std::vector<gpu::Buffer*> buffers{&scene.positions};
    if (variant.output == OUTPUT_DEPTH || variant.output == OUTPUT_OBJECT) return buffers;
    if (plan.shading == Shading::phong) buffers.push_back(&scene.normals);
    if (plan.shading == Shading::gouraud) buffers.push_back(&scene.vertex_colors);
    return buffers;
}

gpu::GraphicsPipeline surface_pipeline(gpu::Device& device, const Plan& plan, const GpuScene& scene, const RasterVariant& variant,
                                       vk::CullModeFlags cull) {
    gpu::GraphicsDesc desc;
    desc.name = cull ? "surface, one-sided" : "surface, two-sided";
    desc.vertex = find_shader("raster/surface.vert");
    desc.fragment = find_shader("raster/surface.frag");
    desc.constants = constants_of(plan, scene, variant);
    desc.push_size = sizeof(gpu_layout::ShadePush);
    desc.vertex_buffers = vertex_layouts(plan, variant);
    desc.color_formats = {kRadiance};
    desc.depth_format = kDepth;
    desc.samples = variant.samples;
    desc.cull = cull;
    return gpu::make_graphics(device, desc);
}

gpu_layout::ShadePush push_of(const RasterDraw& draw, const Frame& frame) {
    gpu_layout::ShadePush push{};
    push.clip_from_frame = draw.view.clip_from_frame(frame, draw.shift);
    push.eye = draw.view.eye_in_frame(frame);
    push.ambient = draw.ambient;
    push.first_light = draw.first_light, push.end_light = draw.end_light;
    return push;
}

// Work groups of 64 for a number of points, as rows of at most 65 535: the least that every device takes along x.
gpu::Groups groups_for(std::uint32_t points) {
    const std::uint32_t groups = (points + 63) / 64, rows = (groups + 65534) / 65535;
    return {rows > 1 ? 65535u : groups, std::max(rows, 1u)};
}

void record_shade(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterPipelines& pipelines,
                  gpu_layout::ShadePush push) {
    const bool flat = plan.shading == Shading::flat;
    push.point_count = flat ? scene.polygon_count : scene.vertex_count;
    gpu::Bindings bindings{{"Colors", flat ? scene.polygon_colors : scene.vertex_colors}};
    offer_table(bindings, "materials", scene.materials);
    offer_table(bindings, "lights", scene.lights);
    offer_table(bindings, "positions", flat ? scene.polygon_positions : scene.positions);
    offer_table(bindings, "normals", flat ? scene.polygon_normals : scene.normals);
    recorder.compute(flat ? "shade-polygons" : "shade-vertices", pipelines.shade, bindings, push, groups_for(push.point_count));
}

gpu::RenderTargets render_targets(const Plan& plan, RasterTargets& targets, glm::vec3 background) {
    gpu::ColorTarget color;
    color.clear = vk::ClearColorValue(std::array{background.r, background.g, background.b, 1.0f});
    color.image = targets.color ? &targets.color : &targets.resolved;
    if (targets.color) color.resolve = &targets.resolved, color.store = false;
    const vk::Offset2D offset(static_cast<std::int32_t>(plan.crop.offset.x), static_cast<std::int32_t>(plan.crop.offset.y));
    return {{color}, gpu::DepthTarget{&targets.depth, 0.0f, false}, {offset, {plan.crop.size.x, plan.crop.size.y}}};
}

std::size_t draw_runs(gpu::DrawContext& d, const gpu::GraphicsPipeline& pipeline, const gpu_layout::ShadePush& push,
                      std::span<const Cluster> clusters) {
    if (clusters.empty()) return 0;
    std::size_t indices = 0;
    d.use(pipeline);
    d.push(push);
    for (const IndexRun& run : visible_runs(clusters, push.clip_from_frame, push.eye)) {
        d.draw_indexed(run.count, run.first);
        indices += run.count;
    }
    return indices / 3;
}

} // namespace

RasterTargets make_targets(gpu::Device& device, glm::uvec2 size, unsigned samples, const std::string& name) {
    const vk::Extent2D extent{size.x, size.y};
    RasterTargets targets;
    targets.resolved = gpu::make_image(device, name, extent, kRadiance,
                                       ImageUsageFlagBits::eColorAttachment | ImageUsageFlagBits::eSampled | ImageUsageFlagBits::eStorage);
    if (samples > 1)
        targets.color = gpu::make_image(device, name + ", samples", extent, kRadiance, ImageUsageFlagBits::eColorAttachment, samples);
    targets.depth = gpu::make_image(device, "depth", extent, kDepth, ImageUsageFlagBits::eDepthStencilAttachment, samples);
    return targets;
}

RasterPipelines make_raster_pipelines(gpu::Device& device, const Plan& plan, const GpuScene& scene, const RasterVariant& variant,
                                      std::size_t one_sided_clusters, std::size_t two_sided_clusters) {
    RasterPipelines pipelines;
    if (shades_points(plan, variant))
        pipelines.shade = gpu::make_compute(device, find_shader("raster/shade_points.comp"), constants_of(plan, scene, variant),
                                            sizeof(gpu_layout::ShadePush));
    if (one_sided_clusters) pipelines.one_sided = surface_pipeline(device, plan, scene, variant, vk::CullModeFlagBits::eBack);
    if (two_sided_clusters) pipelines.two_sided = surface_pipeline(device, plan, scene, variant, vk::CullModeFlagBits::eNone);
    return pipelines;
}

std::size_t record_raster(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterGeometry& geometry,
                          const RasterVariant& variant, const RasterPipelines& pipelines, RasterTargets& targets, const RasterDraw& draw) {
    const gpu_layout::ShadePush push = push_of(draw, geometry.frame);
    if (pipelines.shade) record_shade(recorder, plan, scene, pipelines, push);
    gpu::DrawPass pass;
    for (const auto* p : {&pipelines.one_sided, &pipelines.two_sided})
        if (*p) pass.pipelines.push_back(p);
    pass.targets = render_targets(plan, targets, draw.background);
    if (scene.positions) pass.vertex_buffers = vertex_buffers(scene, plan, variant);
    if (scene.indices) pass.index_buffer = &scene.indices;
    offer_table(pass.bindings, "materials", scene.materials);
    offer_table(pass.bindings, "lights", scene.lights);
    offer_table(pass.bindings, "polygon_colors", scene.polygon_colors);
    offer_table(pass.bindings, "polygon_objects", scene.polygon_objects);
    const std::span all(geometry.clusters);
    std::size_t triangles = 0;
    recorder.draw(draw.name, pass, [&](gpu::DrawContext& d) {
        triangles += draw_runs(d, pipelines.one_sided, push, all.first(geometry.one_sided_clusters));
        triangles += draw_runs(d, pipelines.two_sided, push, all.subspan(geometry.one_sided_clusters));
    });
    return triangles;
}

} // namespace lightbench
