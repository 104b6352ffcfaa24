// Hemi-cubes by the rasteriser: five drawings each, into one image that is copied to the items.
#include "render/radiosity/hemicube_state.h"
#include "render/shaders.h"

namespace lightbench {
namespace {

using namespace gpu_layout;
constexpr vk::Format kItem = vk::Format::eR32Uint, kDepth = vk::Format::eD32Sfloat;

gpu::GraphicsPipeline make_pipeline(HemicubeState& s) {
    gpu::GraphicsDesc desc;
    desc.name = "hemicube-face";
    desc.vertex = find_shader("radiosity/hemicube_face.vert");
    desc.fragment = find_shader("radiosity/hemicube_face.frag");
    desc.constants = s.constants();
    desc.push_size = sizeof(HemicubePush);
    desc.vertex_buffers = {
        {sizeof(FaceVertex),
         {{0, vk::Format::eR32G32B32Sfloat, offsetof(FaceVertex, position)}, {1, vk::Format::eR32G32Uint, offsetof(FaceVertex, sides)}}}};
    desc.color_formats = {kItem};
    desc.depth_format = kDepth;
    return gpu::make_graphics(s.device, desc);
}

// Of the image of all faces: the top, or the half of a side that lies above the horizon.
vk::Rect2D area_of(std::uint32_t face, std::uint32_t n) {
    const std::uint32_t row = face == 0 ? 0 : n + (face - 1) * (n / 2);
    return {{0, static_cast<std::int32_t>(row)}, {n, face == 0 ? n : n / 2}};
}

void record_face(gpu::Recorder& recorder, HemicubeState& s, std::uint32_t cube, std::uint32_t face) {
    const vk::Rect2D area = area_of(face, s.request.resolution);
    gpu::DrawPass pass;
    pass.pipelines = {&s.faces.pipeline};
    const vk::ClearColorValue none(std::array{kNoElement, kNoElement, kNoElement, kNoElement});
    pass.targets.colors = {{.image = &s.faces.items, .clear = none}};
    pass.targets.depth = gpu::DepthTarget{&s.faces.depth, 0.0f, false};
    pass.targets.area = area;
    pass.viewport = vk::Viewport{.x = 0,
                                 .y = static_cast<float>(area.offset.y),
                                 .width = static_cast<float>(area.extent.width),
                                 .height = static_cast<float>(area.extent.height),
                                 .minDepth = 0,
                                 .maxDepth = 1};
    pass.vertex_buffers = {&s.faces.vertices};
    pass.index_buffer = &s.faces.indices;
    offer_table(pass.bindings, "views", s.views);
    recorder.draw("hemicube-face", pass, [&](gpu::DrawContext& d) {
        d.push(HemicubePush{0, s.elements, cube, face, 0});
        d.draw_indexed(s.faces.index_count);
    });
}

} // namespace

HemicubeFaces make_faces(HemicubeState& s, const HemicubeMesh& mesh) {
    using Use = vk::ImageUsageFlagBits;
    const vk::Extent2D extent{s.request.resolution, 3 * s.request.resolution};
    HemicubeFaces f;
    f.vertices = gpu::make_filled_buffer<FaceVertex>(s.device, "hemicube-vertices", mesh.vertices, vk::BufferUsageFlagBits::eVertexBuffer);
    f.indices = gpu::make_filled_buffer<std::uint32_t>(s.device, "hemicube-indices", mesh.indices, vk::BufferUsageFlagBits::eIndexBuffer);
    f.index_count = static_cast<std::uint32_t>(mesh.indices.size());
    f.items = gpu::make_image(s.device, "hemicube-faces", extent, kItem, Use::eColorAttachment);
    f.depth = gpu::make_image(s.device, "hemicube-depth", extent, kDepth, Use::eDepthStencilAttachment);
    f.packed = gpu::make_buffer(s.device, "hemicube-packed", std::uint64_t{s.face_items()} * 4, {});
    f.pipeline = make_pipeline(s);
    return f;
}

void record_faces(gpu::Recorder& recorder, HemicubeState& s) {
    const std::uint64_t bytes = std::uint64_t{s.face_items()} * 4;
    for (std::uint32_t cube = 0; cube < s.request.batch; ++cube) {
        for (std::uint32_t face = 0; face < 5; ++face) record_face(recorder, s, cube, face);
        recorder.copy_to_buffer(s.faces.items, s.faces.packed, {{0, 0}, s.faces.items.extent()});
        recorder.copy(s.faces.packed, s.items, bytes, 0, cube * bytes);
    }
}

} // namespace lightbench
