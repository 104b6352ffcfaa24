// Pipelines and targets of the rasteriser.
#include "render/raster.h"
#include "render/raster_streams.h"
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

gpu::GraphicsDesc desc_of(const Plan& plan, const GpuScene& scene, const RasterVariant& variant, const char* fragment) {
    gpu::GraphicsDesc desc;
    desc.vertex = find_shader("raster/surface.vert");
    desc.fragment = find_shader(fragment);
    desc.constants = constants_of(plan, scene, variant);
    desc.push_size = sizeof(gpu_layout::ShadePush);
    desc.depth_format = kDepth;
    desc.samples = variant.samples;
    for (const VertexStream& stream : vertex_streams(plan, variant)) desc.vertex_buffers.push_back(stream.layout);
    return desc;
}

SurfacePipelines make_both(gpu::Device& device, gpu::GraphicsDesc desc, const std::string& name, bool one_sided, bool two_sided) {
    SurfacePipelines made;
    desc.name = name + ", one-sided", desc.cull = vk::CullModeFlagBits::eBack;
    if (one_sided) made.one_sided = gpu::make_graphics(device, desc);
    desc.name = name + ", two-sided", desc.cull = vk::CullModeFlagBits::eNone;
    if (two_sided) made.two_sided = gpu::make_graphics(device, desc);
    return made;
}

gpu::GraphicsPipeline background_pipeline(gpu::Device& device, const Plan& plan, const GpuScene& scene, const RasterVariant& variant) {
    gpu::GraphicsDesc desc = desc_of(plan, scene, variant, "raster/background.frag");
    desc.name = "background", desc.vertex = find_shader("raster/background.vert");
    desc.vertex_buffers.clear();
    desc.color_formats = {kRadiance};
    desc.depth_write = false, desc.depth_compare = vk::CompareOp::eGreaterOrEqual; // reversed: what was cleared is 0
    return gpu::make_graphics(device, desc);
}

void add_layer_pipelines(gpu::Device& device, const Plan& plan, const GpuScene& scene, const RasterGeometry& geometry,
                         const RasterVariant& variant, RasterPipelines& pipelines) {
    const std::size_t translucent = geometry.clusters.size() - geometry.opaque_clusters;
    const bool one_sided = geometry.translucent_one_sided_clusters > 0, two_sided = translucent > geometry.translucent_one_sided_clusters;
    RasterVariant places = variant;
    places.output = OUTPUT_DEPTH;
    gpu::GraphicsDesc count = desc_of(plan, scene, places, "raster/count_layers.frag");
    count.depth_write = false;
    pipelines.count = make_both(device, count, "count-layers", one_sided, two_sided);
    gpu::GraphicsDesc list = desc_of(plan, scene, variant, "raster/layer.frag");
    list.depth_write = false;
    pipelines.list = make_both(device, list, "list-layers", one_sided, two_sided);
}

} // namespace

bool RasterVariant::has_layers() const {
    return (effects & EFFECT_TRANSPARENCY) && (output == OUTPUT_RADIANCE || output == OUTPUT_ATTENUATION);
}

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

RasterPipelines make_raster_pipelines(gpu::Device& device, const Plan& plan, const GpuScene& scene, const RasterGeometry& geometry,
                                      const RasterVariant& variant) {
    RasterPipelines pipelines;
    if (shades_points(plan, variant))
        pipelines.shade = gpu::make_compute(device, find_shader("raster/shade_points.comp"), constants_of(plan, scene, variant),
                                            sizeof(gpu_layout::ShadePush));
    const bool in_double = plan.precision == Precision::float64 && variant.output == OUTPUT_RADIANCE;
    gpu::GraphicsDesc desc = desc_of(plan, scene, variant, in_double ? "raster/surface_float64.frag" : "raster/surface.frag");
    desc.color_formats = {kRadiance};
    std::size_t one_sided = geometry.one_sided_clusters, two_sided = geometry.opaque_clusters - geometry.one_sided_clusters;
    if (!variant.has_layers()) {
        const std::size_t translucent = geometry.clusters.size() - geometry.opaque_clusters;
        one_sided += geometry.translucent_one_sided_clusters, two_sided += translucent - geometry.translucent_one_sided_clusters;
    } else {
        add_layer_pipelines(device, plan, scene, geometry, variant, pipelines);
    }
    pipelines.surfaces = make_both(device, desc, "surface", one_sided > 0, two_sided > 0);
    if (variant.effects & EFFECT_BACKGROUND_MAP) pipelines.background = background_pipeline(device, plan, scene, variant);
    return pipelines;
}

} // namespace lightbench
