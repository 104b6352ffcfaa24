// Frames in tiles, and the buffers for them.
#include "render/raytrace.h"

#include "gpu/errors.h"
#include "render/ray_tiles.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

using namespace gpu_layout;

// Rays of a generation at most: a dispatch takes far longer than starting it (50 to 90 us on a CPU driver), and buffers stay below 128 MiB.
constexpr std::uint32_t kCapacity = 1u << 18;
constexpr std::uint32_t kNodesPerRay = 4;    // of the tree, for each ray of a full generation
constexpr std::uint32_t kLightsPerPiece = 8; // whose visibility is kept at once

// In halves, until the trees fit.
void trace_tile(RayTracer& tracer, const RayWork& work, const RayFrame& frame, const Tile& tile, gpu::Image& image) {
    const RayStatistics before = tracer.counts;
    if (TileTracer(tracer, work, frame).trace(tile, image)) return;
    tracer.counts = before;
    if (tile.count() == 1)
        throw gpu::EnvironmentError(fmt::format("the ray tree of pixel {}, {} has more than {} rays: lower --depth, or raise --cutoff",
                                                tile.x, tile.y, tracer.buffers.capacity));
    Tile a = tile, b = tile;
    if (tile.height > 1)
        a.height = tile.height / 2, b.y += a.height, b.height -= a.height;
    else
        a.width = tile.width / 2, b.x += a.width, b.width -= a.width;
    trace_tile(tracer, work, frame, a, image);
    trace_tile(tracer, work, frame, b, image);
}

RayBuffers make_buffers(gpu::Device& device, const Plan& plan, std::uint32_t lights) {
    RayBuffers b;
    const std::uint64_t pixels = std::uint64_t{plan.crop.size.x + 2} * (plan.crop.size.y + 2);
    const bool one = !(plan.ray_effects & kSpawns);
    // The tree of a single pixel must fit, however small the image: a crop is refused no sooner than the whole.
    b.capacity = one ? static_cast<std::uint32_t>(std::clamp<std::uint64_t>(pixels, 4096, kCapacity)) : kCapacity;
    b.nodes = b.capacity * (one ? 1 : kNodesPerRay);
    b.lights = std::clamp(lights, 1u, kLightsPerPiece);
    const auto table = [&](const char* name, std::uint64_t bytes) { return gpu::make_texel_buffer(device, name, bytes); };
    const std::uint64_t n = b.capacity;
    b.rays[0] = table("rays", n * sizeof(Ray));
    b.rays[1] = table("rays-next", (one ? 1 : n) * sizeof(Ray));
    if (plan.ray_effects & RAY_REFRACTED) b.media = {table("media", n * sizeof(RayMedia)), table("media-next", n * sizeof(RayMedia))};
    b.hits = table("hits", n * sizeof(RayHit));
    b.hit_rays = table("hit-rays", (n + 3) / 4 * 16);
    b.points = table("points", n * sizeof(RayPoint));
    if (plan.ray_effects & RAY_SHADOWS) b.visibility = table("visibility", n * b.lights * sizeof(glm::vec4));
    if ((plan.ray_effects & RAY_SHADOWS) && (plan.effects & EFFECT_COMPENSATED_SUM)) b.carries = table("carries", n * sizeof(glm::vec4));
    b.tree = table("ray-tree", std::uint64_t{b.nodes} * sizeof(RayNode));
    b.camera = gpu::make_buffer(device, "camera", sizeof(EyePush), vk::BufferUsageFlagBits::eUniformBuffer, gpu::Memory::upload);
    b.counters = gpu::make_buffer(device, "counters", sizeof(RayCounters), vk::BufferUsageFlagBits::eStorageBuffer, gpu::Memory::readback);
    return b;
}

} // namespace

RayTracer make_ray_tracer(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan) {
    RayTracer tracer;
    tracer.lights = static_cast<std::uint32_t>(plan.lights);
    tracer.scene = upload_rays(device, scene, geometry, plan);
    tracer.buffers = make_buffers(device, plan, tracer.lights);
    for (const gpu::Buffer* b : {&tracer.buffers.rays[0], &tracer.buffers.points, &tracer.buffers.tree, &tracer.buffers.visibility})
        if (*b && !b->as_texel()) tracer.scene.fetch_storage |= FETCH_RAYS;
    return tracer;
}

void warm_up(RayTracer& tracer, const RayWork& work, const RayFrame& frame, gpu::Image& image) {
    TileTracer(tracer, work, frame).warm_up(image);
}

bool trace_frame(RayTracer& tracer, const RayWork& work, const RayFrame& frame, gpu::Image& image) {
    const Rect& area = frame.area;
    const std::uint32_t rows = std::max(tracer.buffers.capacity / area.size.x & ~1u, 1u),
                        most = std::min(area.size.x, tracer.buffers.capacity);
    for (std::uint32_t y = 0; y < area.size.y; y += rows)
        for (std::uint32_t x = 0; x < area.size.x; x += most) {
            const Tile tile{area.offset.x + x, area.offset.y + y, std::min(most, area.size.x - x), std::min(rows, area.size.y - y)};
            trace_tile(tracer, work, frame, tile, image);
            if (work.stopped()) return false;
            if (work.progress) work.progress(double(y + tile.height) / area.size.y);
        }
    return true;
}

bool trace_points(RayTracer& tracer, const RayWork& work, const RayFrame& frame, std::uint32_t count, gpu::Image& image) {
    for (std::uint32_t first = 0; first < count; first += tracer.buffers.capacity) {
        trace_tile(tracer, work, frame, {first, 0, std::min(tracer.buffers.capacity, count - first), 1}, image);
        if (work.stopped()) return false;
    }
    return true;
}

} // namespace lightbench