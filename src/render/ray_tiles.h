// The rays of one tile, or of one batch of listed points: generation after generation, then the trees. Inside this room only.
#pragma once

#include "render/ray_pipelines.h"

#include <optional>

namespace lightbench {

// Of listed points: x the first of them, width their number, height 1.
struct Tile {
    std::uint32_t x = 0, y = 0, width = 0, height = 0; // pixels
    std::uint32_t count() const { return width * height; }
    std::uint32_t packed() const { return width | height << 16; }
};

// A generation in the tree: nodes first to first + count; or its hits, which are fewer.
struct Generation {
    std::uint32_t first = 0, count = 0;
    bool sends = false; // some of its rays have children
};

class TileTracer {
  public:
    TileTracer(RayTracer& tracer, const RayWork& work, const RayFrame& frame) : t_(tracer), w_(work), frame_(frame), b_(tracer.buffers) {}
    // False if its trees outgrow the buffers.
    bool trace(const Tile& tile, gpu::Image& image);
    void warm_up(gpu::Image& image);

  private:
    bool makes_eye_rays() const;
    bool sums_light() const;
    std::uint32_t eye_effects() const;
    gpu_layout::EyePush camera_of(const Tile& tile);
    void begin(const Tile& tile);
    void record_eye();
    bool run_generation(const Generation& g);
    void record_trace(const Generation& g, std::uint32_t resume);
    void record_shade(const Generation& g);
    void record_shadows(const Generation& g, gpu_layout::RayPush push, std::uint32_t lights);
    void record_light(const Generation& g, const gpu_layout::RayPush& push);
    template <class Shadows> void each_piece(const Generation& g, Shadows&& shadows);
    template <class Record> void until_done(Record&& record);
    std::optional<std::uint32_t> find_hits(const Generation& g);
    std::optional<gpu_layout::RayCounters> shade_hits(const Generation& hits);
    bool make_walks(std::uint32_t count);
    void add(const gpu_layout::RayCounters& c);
    void gather_and_film(const Tile& tile, gpu::Image& image);
    void record_pixels(const Tile& tile);
    gpu_layout::RayPush push_for(const Generation& g) const;
    gpu::Bindings with_structure(gpu::Bindings bindings);
    gpu::Bindings with_primitives(gpu::Bindings bindings);
    gpu::Bindings with_meshes(gpu::Bindings bindings);
    void compute(const char* name, RayPass pass, gpu::Bindings bindings, const gpu_layout::RayPush& push, std::uint32_t more = 0,
                 std::uint32_t layers = 1);
    gpu_layout::RayCounters submit();
    std::uint32_t packets() const;
    std::uint32_t room() const { return std::min(b_.capacity, b_.nodes - next_); }

    RayTracer& t_;
    const RayWork& w_;
    const RayFrame& frame_;
    RayBuffers& b_;
    std::vector<Generation> generations_;
    gpu_layout::EyePush camera_{}; // of the tile
    unsigned now_ = 0;             // which of the two buffers of rays holds this generation
    std::uint32_t next_ = 0;       // node of the first ray of the next generation
    std::uint32_t expected_ = 0;   // invocations that must have ended
};

} // namespace lightbench
