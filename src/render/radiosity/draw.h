// Elements as they are drawn: by values at their corners. In: PatchMesh, radiosity. Out: passes recorded. Inside this room only.
#pragma once

#include "plan/complete.h"
#include "radiosity/patches.h"
#include "render/raster.h"

#include <span>

namespace lightbench {

struct ElementDrawing {
    gpu::Buffer positions, colors, indices;
    gpu::GraphicsPipeline pipeline;
    std::vector<std::uint32_t> vertices; // four an element: which vertex each corner is
    std::size_t vertex_count = 0;
};

// A corner that elements of one group share is one vertex; with `apart` each element has corners of its own.
ElementDrawing make_drawing(gpu::Device& device, const PatchMesh& mesh, unsigned samples, bool apart);

// radiance: four a element, of its corners.
void set_colors(gpu::Device& device, ElementDrawing& drawing, std::span<const std::array<glm::vec3, 4>> radiance);

// Clears the targets first. Returns the number of triangles.
std::size_t record_elements(gpu::Recorder& recorder, ElementDrawing& drawing, const RasterDraw& draw, const Frame& frame,
                            gpu::RenderTargets targets);

} // namespace lightbench
