#include "render/radiosity/draw.h"

#include "render/shaders.h"
#include "shared/layouts.h"

#include <map>

namespace lightbench {
namespace {

constexpr vk::Format kVec3 = vk::Format::eR32G32B32Sfloat;

std::vector<std::uint32_t> triangles_of(const PatchMesh& mesh, const std::vector<std::uint32_t>& vertices) {
    std::vector<std::uint32_t> indices;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const std::uint32_t* v = &vertices[4 * e];
        indices.insert(indices.end(), {v[0], v[1], v[2]});
        if (mesh.elements[e].size() == 4) indices.insert(indices.end(), {v[0], v[2], v[3]});
    }
    return indices;
}

gpu::GraphicsPipeline pipeline_for(gpu::Device& device, unsigned samples) {
    gpu::GraphicsDesc desc;
    desc.name = "elements";
    desc.vertex = find_shader("radiosity/surface.vert"), desc.fragment = find_shader("radiosity/surface.frag");
    desc.push_size = sizeof(gpu_layout::ShadePush);
    desc.vertex_buffers = {{12, {{0, kVec3, 0}}}, {12, {{1, kVec3, 0}}}};
    desc.color_formats = {vk::Format::eR32G32B32A32Sfloat}, desc.depth_format = vk::Format::eD32Sfloat;
    desc.samples = samples, desc.cull = vk::CullModeFlagBits::eBack;
    return gpu::make_graphics(device, desc);
}

} // namespace

ElementDrawing make_drawing(gpu::Device& device, const PatchMesh& mesh, unsigned samples, bool apart) {
    ElementDrawing d;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known; // by point and group
    std::vector<glm::vec3> positions;
    d.vertices.assign(4 * mesh.elements.size(), 0);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (std::size_t c = 0; c < mesh.elements[e].size(); ++c) {
            const std::uint32_t point = mesh.elements[e].corners[c];
            const auto [it, made] = known.try_emplace({point, apart ? static_cast<std::uint32_t>(e) : mesh.elements[e].group},
                                                      static_cast<std::uint32_t>(positions.size()));
            if (made) positions.emplace_back(mesh.points[point]);
            d.vertices[4 * e + c] = it->second;
        }
    d.vertex_count = positions.size();
    if (positions.empty()) return d;
    const auto indices = triangles_of(mesh, d.vertices);
    d.positions =
        gpu::make_filled_buffer(device, "element-positions", std::span<const glm::vec3>(positions), vk::BufferUsageFlagBits::eVertexBuffer);
    d.indices =
        gpu::make_filled_buffer(device, "element-indices", std::span<const std::uint32_t>(indices), vk::BufferUsageFlagBits::eIndexBuffer);
    d.colors = gpu::make_buffer(device, "element-colors", positions.size() * sizeof(glm::vec3), vk::BufferUsageFlagBits::eVertexBuffer);
    d.pipeline = pipeline_for(device, samples);
    return d;
}

void set_colors(gpu::Device& device, ElementDrawing& drawing, std::span<const std::array<glm::vec3, 4>> radiance) {
    if (drawing.vertex_count == 0) return;
    std::vector<glm::vec3> colors(drawing.vertex_count);
    for (std::size_t e = 0; e < radiance.size(); ++e)
        for (std::size_t c = 0; c < 4; ++c) colors[drawing.vertices[4 * e + c]] = radiance[e][c];
    gpu::upload(device, drawing.colors, std::as_bytes(std::span(colors)));
}

std::size_t record_elements(gpu::Recorder& recorder, ElementDrawing& drawing, const RasterDraw& draw, const Frame& frame,
                            gpu::RenderTargets targets) {
    gpu_layout::ShadePush push{};
    push.clip_from_frame = draw.view.clip_from_frame(frame, draw.shift);
    gpu::DrawPass pass;
    pass.targets = std::move(targets);
    if (drawing.pipeline)
        pass.pipelines = {&drawing.pipeline}, pass.vertex_buffers = {&drawing.positions, &drawing.colors},
        pass.index_buffer = &drawing.indices;
    const auto count = drawing.indices ? static_cast<std::uint32_t>(drawing.indices.size() / 4) : 0;
    recorder.draw(draw.name, pass, [&](gpu::DrawContext& d) {
        if (count == 0) return;
        d.push(push);
        d.draw_indexed(count);
    });
    return count / 3;
}

} // namespace lightbench
