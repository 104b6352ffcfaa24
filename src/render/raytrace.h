// The ray tracer: eye rays of a tile, then generation after generation until no ray is left, then the trees gathered from their leaves.
// In: GpuScene, RayScene, a plan, a view. Out: one sample a pixel in an image. Work is cut into tiles, so that memory and the time of a
// dispatch are bounded; a tile whose trees outgrow the buffers is done again in smaller ones. The same bits come out however it is cut.
#pragma once

#include "plan/complete.h"
#include "render/display.h"
#include "render/gpu_scene.h"
#include "render/ray_scene.h"
#include "render/render.h"
#include "shared/rays.h"

#include <array>
#include <functional>
#include <map>

namespace lightbench {

// Buffers for the rays of a batch; `rays` and `media` are those of this generation and of the next.
struct RayBuffers {
    std::array<gpu::Buffer, 2> rays, media;
    gpu::Buffer hits, hit_rays, points, visibility, carries, tree, counters, walks, camera;
    std::uint32_t capacity = 0; // rays of a generation
    std::uint32_t nodes = 0;    // of the ray tree
    std::uint32_t lights = 1;   // that are summed in one piece, for a full generation
};

enum class RayPass { eye, trace, shade, shadow, light, gather, film, film_points, film_pixels };

struct RayTracer {
    RayScene scene;
    RayBuffers buffers;
    std::map<std::pair<RayPass, std::uint32_t>, gpu::ComputePipeline> pipelines; // by RAY_... bits
    RayStatistics counts;
    std::uint32_t lights = 0;     // of the scene
    std::optional<glm::vec3> eye; // frame; whose media these are
    glm::uvec4 eye_media{0};      // surfaces + 1 around it, the innermost first
};

RayTracer make_ray_tracer(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan);

// One sample of every pixel of `area`, or of the listed points.
struct RayFrame {
    const View& view;
    Rect area;                // of the image that is written
    glm::vec2 shift{0.5f};    // within the pixel
    float cell = 0;           // side of the cell in which the sample is jittered; 0: not
    std::uint32_t sample = 0; // its number
    glm::vec3 ambient{0}, background{0};
    glm::ivec2 origin{0};          // where in the picture the image that is written lies
    gpu::Buffer* points = nullptr; // eye rays go through these, and what they see is written to `lattice`: see lattice_list.comp
    gpu::Buffer* lattice = nullptr;
};

// Of a tile's rays: node of the first, their number, how many hit something, and which of the two buffers holds them.
struct TracedGeneration {
    std::uint32_t first = 0, count = 0, hits = 0;
    unsigned buffer = 0;
};

struct RayWork {
    gpu::Device& device;
    gpu::Recorder& recorder; // submitted on the way
    const Plan& plan;
    GpuScene& scene;
    const RasterGeometry& geometry;
    gpu::Timings& times;                                    // appended
    std::function<void(double)> progress;                   // may be empty; the share of the frame that is done
    std::function<bool()> stop{};                           // may be empty; asked between generations of rays: true ends the frame early
    std::function<void(const TracedGeneration&)> observe{}; // may be empty; when a generation is shaded, its buffers as they were left
    std::uint32_t output = 0;                               // OUTPUT_...
    std::uint32_t parts = gpu_layout::kAllParts;            // of what an eye ray sees, as GatherPush
    Display* display = nullptr;                             // not null: what frames show goes to its pixels, and to no image
    bool stopped() const { return stop && stop(); }
};

// Dispatches every pipeline once without work: drivers compile at the first dispatch, which is not the time that tracing takes.
void warm_up(RayTracer& tracer, const RayWork& work, const RayFrame& frame, gpu::Image& image);

// Writes `image` (linear radiance, alpha 1), or work.display. EnvironmentError if the tree of a single pixel does not fit. False: stopped early; the tiles
// that were not reached are not written.
bool trace_frame(RayTracer& tracer, const RayWork& work, const RayFrame& frame, gpu::Image& image);

// The first `count` of the frame's points. False: stopped early.
bool trace_points(RayTracer& tracer, const RayWork& work, const RayFrame& frame, std::uint32_t count, gpu::Image& image);

} // namespace lightbench
