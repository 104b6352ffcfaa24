// Generations of rays: hits are found, shaded, lit; what they send on is the next generation.
#include "render/ray_tiles.h"

#include "shared/rays.h"

#include <algorithm>

namespace lightbench {

using namespace gpu_layout;

// The lights in pieces whose visibility fits; each piece adds to the colors of the one before. shadows(push, lights) finds it out.
template <class Shadows> void TileTracer::each_piece(const Generation& g, Shadows&& shadows) {
    const bool cast = w_.plan.ray_effects & RAY_SHADOWS;
    const auto room = static_cast<std::uint32_t>(b_.visibility ? b_.visibility.size() / 16 / g.count : t_.lights);
    const std::uint32_t piece = std::max(1u, cast ? std::min(room, t_.lights) : t_.lights);
    std::uint32_t first = 0;
    do {
        RayPush push = push_for(g);
        push.first_light = first, push.end_light = std::min(first + piece, t_.lights), push.more = first > 0;
        if (cast) shadows(push, push.end_light - first);
        record_light(g, push);
        first += piece;
    } while (first < t_.lights);
}

// record(resume) until every walk has ended: those that spend their steps are put down, and taken up in the next dispatch.
template <class Record> void TileTracer::until_done(Record&& record) {
    for (std::uint32_t resume = 0;; resume = 1) {
        w_.recorder.fill(b_.counters, 0);
        record(resume);
        const RayCounters round = submit();
        add(round);
        if (round.unfinished == 0) return;
    }
}

// The number of hits; nothing if some walks spent their steps and there is no room to put them down.
std::optional<std::uint32_t> TileTracer::find_hits(const Generation& g) {
    record_trace(g, 0);
    RayCounters c = submit();
    if (c.unfinished == 0) return add(c), c.hits;
    const bool made_there = makes_eye_rays();
    if (!make_walks(g.count)) return std::nullopt;
    if (made_there) {
        w_.recorder.fill(b_.counters, 0);
        record_eye();
        submit();
    }
    until_done([&](std::uint32_t resume) { record_trace(g, resume); });
    w_.recorder.fill(b_.counters, 0);
    record_trace(g, kCollect);
    c = submit();
    b_.walks = {};
    return add(c), c.hits;
}

bool TileTracer::make_walks(std::uint32_t count) {
    const std::uint64_t bytes = std::uint64_t{count} * 4 * (kRayWalkWords + t_.scene.stack);
    if (bytes > w_.device.info().max_storage_range) return false;
    b_.walks = gpu::make_buffer(w_.device, "walks", bytes, vk::BufferUsageFlagBits::eStorageBuffer);
    return true;
}

// Surfaces, lights and the next generation's rays.
std::optional<RayCounters> TileTracer::shade_hits(const Generation& hits) {
    w_.recorder.fill(b_.counters, 0);
    record_shade(hits);
    if (!sums_light()) return submit();
    each_piece(hits, [&](const RayPush& push, std::uint32_t lights) { record_shadows(hits, push, lights); });
    RayCounters c = submit();
    if (c.unfinished == 0) return c;
    if (!make_walks(hits.count)) return std::nullopt;
    w_.recorder.fill(b_.counters, 0);
    record_shade(hits);
    c = submit();
    each_piece(hits, [&](RayPush push, std::uint32_t lights) {
        for (push.layer = 0; push.layer < lights; ++push.layer)
            until_done([&](std::uint32_t resume) {
                push.resume = resume;
                record_shadows(hits, push, 1);
            });
        w_.recorder.fill(b_.counters, 0);
    });
    submit();
    b_.walks = {};
    return c;
}

void TileTracer::add(const RayCounters& c) {
    RayStatistics& all = t_.counts;
    all.shadow += c.shadow_rays, all.reflected += c.reflected, all.refracted += c.refracted, all.straight += c.straight;
    all.nodes += c.nodes, all.voxels += c.voxels, all.triangles += c.triangles, all.spheres += c.spheres;
    all.boxes += c.boxes, all.balls += c.balls, all.cones += c.cones, all.tori += c.tori;
}

// False if the next generation has no room.
bool TileTracer::run_generation(const Generation& g) {
    const auto hits = find_hits(g);
    if (!hits) return false;
    if (generations_.size() == 1) t_.counts.eye += g.count, t_.counts.eye_hit += *hits;
    if (*hits == 0 && w_.observe) w_.observe({g.first, g.count, 0, now_});
    if (*hits == 0) return true;
    const auto c = shade_hits({g.first, *hits});
    if (!c || c->children > room()) return false;
    add(*c);
    if (w_.observe) w_.observe({g.first, g.count, *hits, now_});
    generations_.back().sends = c->children > 0;
    next_ += c->children;
    if (c->children == 0) return true;
    generations_.push_back({g.first + g.count, c->children, false});
    now_ = 1 - now_;
    w_.recorder.fill(b_.counters, 0);
    return true;
}

void TileTracer::warm_up(gpu::Image& image) {
    // Where memory is the host's, its pages are made when they are first written to, which took a fifth of the first frame. A small image
    // uses so little of the buffers that touching all of them would take longer.
    const bool large = frame_.area.size.x * frame_.area.size.y >= b_.capacity / 4;
    for (gpu::Buffer* b : {&b_.rays[0], &b_.rays[1], &b_.hits, &b_.hit_rays, &b_.points, &b_.visibility, &b_.tree})
        if (*b && large && w_.device.info().is_cpu) w_.recorder.fill(*b, 0);
    w_.recorder.fill(b_.hit_rays, 0); // SwiftShader also loads for lanes that have returned: what is read as an index must be one
    w_.recorder.fill(b_.counters, 0);
    const Tile nothing{frame_.area.offset.x, frame_.area.offset.y, 0, 0};
    begin(nothing);
    const Generation none{};
    for (const std::size_t generations : {1, 2}) { // rays that go together, and those that do not
        generations_.resize(generations);
        if (generations == 2 && !(w_.plan.ray_effects & kSpawns)) break;
        record_trace(none, 0);
        RayPush push = push_for(none);
        if (w_.plan.ray_effects & RAY_SHADOWS) record_shadows(none, push, 1);
    }
    record_shade(none);
    record_light(none, push_for(none));
    generations_ = {{0, 0, bool(w_.plan.ray_effects & kSpawns)}};
    gather_and_film(nothing, image);
    w_.recorder.submit_and_wait();
}

bool TileTracer::trace(const Tile& tile, gpu::Image& image) {
    generations_ = {{0, tile.count(), false}};
    now_ = 0, next_ = tile.count();
    begin(tile);
    for (std::size_t i = 0; i < generations_.size(); ++i) {
        const Generation g = generations_[i];
        if (w_.stopped()) return true;
        if (!run_generation(g)) return false;
        if (w_.parts == 1u << kRayEye) break; // nobody asks what comes back
    }
    gather_and_film(tile, image);
    return true;
}

} // namespace lightbench
