#include "render/raster_streams.h"

#include "shared/effects.h"
#include "shared/layouts.h"

namespace lightbench {
namespace {

constexpr vk::Format kVec2 = vk::Format::eR32G32Sfloat, kVec3 = vk::Format::eR32G32B32Sfloat, kUint = vk::Format::eR32Uint;

// Front, then back; each one color, or two where a texture modulates it.
VertexStream color_stream(const RasterVariant& variant) {
    const bool textured = variant.effects & EFFECT_ANY_TEXTURE, two_sided = variant.effects & EFFECT_TWO_SIDED;
    const std::uint32_t side = textured ? 32 : 16;
    gpu::VertexLayout layout{two_sided ? 2 * side : side, {{4, kVec3, 0}}};
    if (two_sided) layout.attributes.push_back({5, kVec3, side});
    if (textured) layout.attributes.push_back({6, kVec3, 16});
    if (textured && two_sided) layout.attributes.push_back({7, kVec3, side + 16});
    return {layout, &GpuScene::vertex_colors};
}

VertexStream detail_stream() {
    using gpu_layout::PointDetail;
    return {{sizeof(PointDetail),
             {{8, kVec2, offsetof(PointDetail, uv)},
              {9, kVec3, offsetof(PointDetail, u_gradient)},
              {10, kVec3, offsetof(PointDetail, v_gradient)}}},
            &GpuScene::detail};
}

} // namespace

std::vector<VertexStream> vertex_streams(const Plan& plan, const RasterVariant& variant) {
    std::vector<VertexStream> streams{{{16, {{0, kVec3, 0}, {1, kUint, 12}}}, &GpuScene::positions}};
    if (variant.output == OUTPUT_DEPTH || variant.output == OUTPUT_OBJECT) return streams;
    const bool looks_up = variant.effects & (EFFECT_ANY_TEXTURE | EFFECT_TRANSPARENCY);
    if (plan.shading == Shading::phong || looks_up) streams.push_back({{16, {{2, kVec3, 0}, {3, kUint, 12}}}, &GpuScene::normals});
    if (plan.shading == Shading::gouraud) streams.push_back(color_stream(variant));
    if (variant.effects & EFFECT_MAP_UV) streams.push_back(detail_stream());
    return streams;
}

} // namespace lightbench
