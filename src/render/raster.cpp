// Passes of the rasteriser.
#include "render/raster.h"

#include "render/cull.h"
#include "render/raster_streams.h"
#include "shared/effects.h"
#include "shared/layouts.h"

namespace lightbench {
namespace {

gpu_layout::ShadePush push_of(const RasterDraw& draw, const GpuScene& scene, const Frame& frame) {
    gpu_layout::ShadePush push{};
    push.clip_from_frame = draw.view.clip_from_frame(frame, draw.shift);
    push.eye = draw.view.eye_in_frame(frame);
    push.ambient = draw.ambient;
    push.first_light = draw.first_light, push.end_light = draw.end_light;
    push.environment = scene.environment;
    return push;
}

void record_shade(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterPipelines& pipelines,
                  gpu_layout::ShadePush push) {
    const bool flat = plan.shading == Shading::flat;
    push.point_count = flat ? scene.polygon_count : scene.vertex_count;
    gpu::Bindings bindings{{"Colors", flat ? scene.polygon_colors : scene.vertex_colors}};
    offer_table(bindings, "materials", scene.materials);
    offer_table(bindings, "lights", scene.lights);
    offer_table(bindings, "texels", scene.texels);
    offer_table(bindings, "positions", flat ? scene.polygon_positions : scene.positions);
    offer_table(bindings, "normals", flat ? scene.polygon_normals : scene.normals);
    offer_table(bindings, "detail", flat ? scene.polygon_detail : scene.detail);
    recorder.compute(flat ? "shade-polygons" : "shade-vertices", pipelines.shade, bindings, push, groups_for(push.point_count));
}

vk::Rect2D crop_of(const Plan& plan) {
    return {{static_cast<std::int32_t>(plan.crop.offset.x), static_cast<std::int32_t>(plan.crop.offset.y)},
            {plan.crop.size.x, plan.crop.size.y}};
}

// `first`: cleared. `last`: nothing is drawn over it, so that it may be resolved and its depth forgotten.
gpu::RenderTargets render_targets(const Plan& plan, RasterTargets& targets, glm::vec3 background, bool first, bool last) {
    gpu::ColorTarget color;
    if (first) color.clear = vk::ClearColorValue(std::array{background.r, background.g, background.b, 1.0f});
    color.image = targets.color ? &targets.color : &targets.resolved;
    if (targets.color && last) color.resolve = &targets.resolved, color.store = false;
    gpu::DepthTarget depth{&targets.depth, std::nullopt, !last};
    if (first) depth.clear = 0.0f;
    return {{color}, depth, crop_of(plan)};
}

void add_scene(gpu::DrawPass& pass, const Plan& plan, GpuScene& scene, const RasterVariant& variant) {
    if (scene.positions)
        for (const VertexStream& stream : vertex_streams(plan, variant)) pass.vertex_buffers.push_back(&(scene.*stream.buffer));
    if (scene.indices) pass.index_buffer = &scene.indices;
    if (variant.output == OUTPUT_DEPTH) return;
    offer_table(pass.bindings, "materials", scene.materials);
    offer_table(pass.bindings, "lights", scene.lights);
    offer_table(pass.bindings, "texels", scene.texels);
    offer_table(pass.bindings, "polygon_colors", scene.polygon_colors);
    offer_table(pass.bindings, "polygon_objects", scene.polygon_objects);
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

std::size_t draw_clusters(gpu::DrawContext& d, const SurfacePipelines& pipelines, const gpu_layout::ShadePush& push,
                          std::span<const Cluster> clusters, std::size_t one_sided) {
    return draw_runs(d, pipelines.one_sided, push, clusters.first(one_sided)) +
           draw_runs(d, pipelines.two_sided, push, clusters.subspan(one_sided));
}

std::span<const Cluster> opaque_of(const RasterGeometry& geometry) {
    return std::span(geometry.clusters).first(geometry.opaque_clusters);
}
std::span<const Cluster> translucent_of(const RasterGeometry& geometry) {
    return std::span(geometry.clusters).subspan(geometry.opaque_clusters);
}

void add_pipelines(gpu::DrawPass& pass, const SurfacePipelines& pipelines) {
    for (const auto* p : {&pipelines.one_sided, &pipelines.two_sided})
        if (*p) pass.pipelines.push_back(p);
}

// Directions of the world by pixel: linear, when scaled so that each reaches the plane at distance 1 before the eye.
glm::mat4 direction_from_pixel(const View& view, glm::dvec2 shift) {
    const glm::dvec2 size(view.size);
    const glm::dvec3 forward = view.direction_through(0.5 * size);
    const auto reach = [&](glm::dvec2 pixel) {
        const glm::dvec3 d = view.direction_through(pixel);
        return d / glm::dot(d, forward);
    };
    const glm::dvec3 corner = reach({0, 0}), dx = (reach({size.x, 0}) - corner) / size.x, dy = (reach({0, size.y}) - corner) / size.y;
    return {glm::dvec4(dx, 0), glm::dvec4(dy, 0), glm::dvec4(0), glm::dvec4(corner - shift.x * dx - shift.y * dy, 0)};
}

void record_background(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterPipelines& pipelines, RasterTargets& targets,
                       const RasterDraw& draw, bool last) {
    gpu::DrawPass pass;
    pass.pipelines = {&pipelines.background};
    pass.targets = render_targets(plan, targets, {}, false, last);
    offer_table(pass.bindings, "texels", scene.texels);
    gpu_layout::ShadePush push{};
    push.clip_from_frame = direction_from_pixel(draw.view, draw.shift);
    push.environment = scene.environment;
    recorder.draw("background", pass, [&](gpu::DrawContext& d) {
        d.push(push);
        d.draw(3);
    });
}

} // namespace

gpu::RenderTargets cleared_targets(const Plan& plan, RasterTargets& targets, glm::vec3 background, bool last) {
    return render_targets(plan, targets, background, true, last);
}

void record_map(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterPipelines& pipelines, RasterTargets& targets,
                const RasterDraw& draw) {
    record_background(recorder, plan, scene, pipelines, targets, draw, true);
}

gpu::Groups groups_for(std::uint32_t invocations) {
    const std::uint32_t groups = std::max((invocations + 63) / 64, 1u), rows = (groups + 65534) / 65535;
    return {rows > 1 ? 65535u : groups, rows};
}

std::size_t record_raster(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterGeometry& geometry,
                          const RasterVariant& variant, const RasterPipelines& pipelines, RasterTargets& targets, const RasterDraw& draw) {
    const gpu_layout::ShadePush push = push_of(draw, scene, geometry.frame);
    if (pipelines.shade) record_shade(recorder, plan, scene, pipelines, push);
    const bool layers = variant.has_layers(), background = draw.background_map && pipelines.background;
    gpu::DrawPass pass;
    add_pipelines(pass, pipelines.surfaces);
    pass.targets = render_targets(plan, targets, draw.background, true, !layers && !background);
    if (!pass.pipelines.empty()) add_scene(pass, plan, scene, variant);
    std::size_t triangles = 0;
    recorder.draw(draw.name, pass, [&](gpu::DrawContext& d) {
        triangles += draw_clusters(d, pipelines.surfaces, push, opaque_of(geometry), geometry.one_sided_clusters);
        if (!layers)
            triangles += draw_clusters(d, pipelines.surfaces, push, translucent_of(geometry), geometry.translucent_one_sided_clusters);
    });
    if (background) record_background(recorder, plan, scene, pipelines, targets, draw, !layers);
    return triangles;
}

std::size_t record_translucent(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterGeometry& geometry,
                               const RasterVariant& variant, RasterTargets& targets, const RasterDraw& draw,
                               const TranslucentDraw& translucent) {
    gpu_layout::ShadePush push = push_of(draw, scene, geometry.frame);
    push.list_origin = translucent.list_origin.x | translucent.list_origin.y << 16, push.list_width = translucent.list_width;
    gpu::DrawPass pass;
    add_pipelines(pass, translucent.pipelines);
    pass.targets.depth = gpu::DepthTarget{&targets.depth, std::nullopt, true};
    pass.targets.area = translucent.area;
    add_scene(pass, plan, scene, variant);
    pass.bindings.insert(pass.bindings.end(), translucent.bindings.begin(), translucent.bindings.end());
    std::size_t triangles = 0;
    recorder.draw(translucent.name, pass, [&](gpu::DrawContext& d) {
        triangles = draw_clusters(d, translucent.pipelines, push, translucent_of(geometry), geometry.translucent_one_sided_clusters);
    });
    return triangles;
}

} // namespace lightbench
