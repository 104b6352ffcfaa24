// The rasteriser: shades polygons or vertices where the plan says so, then draws the clusters that the view sees: opaque ones into the
// target, translucent ones as render/layers.h asks. In: GpuScene, a variant of the effect mask, a view. Out: passes recorded.
#pragma once

#include "gpu/recorder.h"
#include "plan/complete.h"
#include "render/gpu_scene.h"

#include <compare>

namespace lightbench {

// One specialisation of the raster shaders.
struct RasterVariant {
    std::uint32_t effects = 0; // EFFECT_... bits
    std::uint32_t output = 0;  // OUTPUT_...
    unsigned samples = 1;
    auto operator<=>(const RasterVariant&) const = default;
    bool has_layers() const; // draws translucent surfaces apart; the other variants draw them as if opaque
};

// With back faces culled, and without; only those that have clusters.
struct SurfacePipelines {
    gpu::GraphicsPipeline one_sided, two_sided;
};

struct RasterPipelines {
    gpu::ComputePipeline shade;       // none for Phong, and where nothing needs shading (depth, object)
    SurfacePipelines surfaces;        // opaque ones, or all
    gpu::GraphicsPipeline background; // none without an environment map
    SurfacePipelines count, list;     // translucent ones; none without layers
};

// Images of one size. `color` and `depth` have the variant's samples; `resolved` has one and is what is read.
struct RasterTargets {
    gpu::Image color, depth, resolved; // color is none if samples is 1: then `resolved` is drawn into
};

RasterTargets make_targets(gpu::Device& device, glm::uvec2 size, unsigned samples, const std::string& name);
RasterPipelines make_raster_pipelines(gpu::Device& device, const Plan& plan, const GpuScene& scene, const RasterGeometry& geometry,
                                      const RasterVariant& variant);

// Groups of 64 invocations, as rows of at most 65 535: the least that every device takes along x.
gpu::Groups groups_for(std::uint32_t invocations);

// One drawing of the scene.
struct RasterDraw {
    const View& view;
    glm::dvec2 shift{0}; // pixels
    glm::vec3 ambient{0};
    glm::vec3 background{0};
    std::uint32_t first_light = 0, end_light = 0;
    std::string name = "raster"; // of the pass
    bool background_map = false;
};

// Returns the number of triangles drawn.
std::size_t record_raster(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterGeometry& geometry,
                          const RasterVariant& variant, const RasterPipelines& pipelines, RasterTargets& targets, const RasterDraw& draw);

// The targets of a drawing that clears them; `last`: nothing is drawn over it.
gpu::RenderTargets cleared_targets(const Plan& plan, RasterTargets& targets, glm::vec3 background, bool last);

// The environment behind what is drawn, the last of a drawing.
void record_map(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterPipelines& pipelines, RasterTargets& targets,
                const RasterDraw& draw);

// One drawing of what is translucent, behind nothing opaque: into no color target; what its fragments do is up to the pipelines.
struct TranslucentDraw {
    std::string name;
    const SurfacePipelines& pipelines;
    vk::Rect2D area;        // pixels: nothing outside is touched
    gpu::Bindings bindings; // besides the scene's
    glm::uvec2 list_origin{0};
    std::uint32_t list_width = 0;
};
std::size_t record_translucent(gpu::Recorder& recorder, const Plan& plan, GpuScene& scene, const RasterGeometry& geometry,
                               const RasterVariant& variant, RasterTargets& targets, const RasterDraw& draw,
                               const TranslucentDraw& translucent);

} // namespace lightbench
