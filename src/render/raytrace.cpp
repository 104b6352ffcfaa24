// Tiles, generations and batches of rays.
#include "render/raytrace.h"

#include "accel/containment.h"
#include "gpu/check.h"
#include "gpu/errors.h"
#include "render/raster.h"
#include "render/shaders.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace lightbench {
namespace {

using namespace gpu_layout;

// Rays of a generation at most: large enough that a dispatch takes longer than starting it (50 to 90 us on a CPU driver), small enough that
// what one pass writes is still in the cache when the next reads it. Measured on the sphereflake: 2^16 to 2^18 are alike within 5 %.
constexpr std::uint32_t kCapacity = 1u << 18;
constexpr std::uint32_t kNodesPerRay = 4;    // of the tree, for each ray of a full generation
constexpr std::uint32_t kLightsPerPiece = 8; // whose visibility is kept at once
constexpr std::uint32_t kSpawns = RAY_REFLECTED | RAY_REFRACTED | RAY_STRAIGHT;

const char* shader_of(RayPass pass) {
    switch (pass) {
    case RayPass::eye: return "raytrace/eye.comp";
    case RayPass::trace: return "raytrace/trace.comp";
    case RayPass::shade: return "raytrace/shade.comp";
    case RayPass::shadow: return "raytrace/shadow.comp";
    case RayPass::light: return "raytrace/light.comp";
    case RayPass::gather: return "raytrace/gather.comp";
    case RayPass::film: return "raytrace/film.comp";
    case RayPass::film_points: return "raytrace/film_points.comp";
    }
    return "";
}

std::size_t push_of(RayPass pass) {
    switch (pass) {
    case RayPass::eye: return sizeof(EyePush);
    case RayPass::gather: return sizeof(GatherPush);
    case RayPass::film:
    case RayPass::film_points: return sizeof(FilmPush);
    default: return sizeof(RayPush);
    }
}

// What may run of the illumination model in a pass: the rest of the mask would only make pipelines differ.
std::uint32_t effects_for(RayPass pass, const Plan& plan) {
    constexpr std::uint32_t kArriving = EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT | EFFECT_ATTENUATION_NONE |
                                        EFFECT_ATTENUATION_LINEAR | EFFECT_ATTENUATION_INVERSE_SQUARE;
    const std::uint32_t effects = plan.effects & ~(EFFECT_TWO_SIDED | EFFECT_VANISHING_NORMALS);
    // Of surfaces that light passes through: how clear they are.
    constexpr std::uint32_t kClear =
        EFFECT_TRANSPARENCY | EFFECT_TEXTURE_ALPHA | EFFECT_TEXTURE | EFFECT_ANY_MAPPING | EFFECT_MANY_MATERIALS;
    if (pass == RayPass::shadow) return effects & (plan.ray_effects & RAY_CLEAR_SHADOWS ? kArriving | kClear : kArriving);
    return effects;
}

const gpu::ComputePipeline& pipeline_of(RayTracer& tracer, const RayWork& w, RayPass pass, std::uint32_t more = 0) {
    const std::uint32_t rays = (w.plan.ray_effects | tracer.scene.effects | more);
    gpu::ComputePipeline& pipeline = tracer.pipelines[{pass, rays}];
    if (pipeline) return pipeline;
    const gpu::Constants constants{{CONSTANT_EFFECTS, effects_for(pass, w.plan)},
                                   {CONSTANT_SHADING, SHADING_PHONG},
                                   {CONSTANT_OUTPUT, OUTPUT_RADIANCE},
                                   {CONSTANT_LIGHT_COUNT, pass == RayPass::light ? w.plan.light_count : 0},
                                   {CONSTANT_FETCH_STORAGE, w.scene.fetch_storage | tracer.scene.fetch_storage},
                                   {CONSTANT_RAY_EFFECTS, rays},
                                   {CONSTANT_ACCEL, static_cast<std::uint32_t>(w.plan.accel)},
                                   {CONSTANT_STACK, tracer.scene.stack},
                                   {CONSTANT_LOOSE, tracer.scene.loose}};
    pipeline = gpu::make_compute(w.device, find_shader(shader_of(pass)), constants, push_of(pass));
    return pipeline;
}

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
    void record_eye(const Tile& tile);
    bool run_generation(const Generation& g);
    void record_trace(const Generation& g, std::uint32_t resume);
    void record_shade(const Generation& g);
    void record_shadows(const Generation& g, RayPush push, std::uint32_t lights);
    void record_light(const Generation& g, const RayPush& push);
    template <class Shadows> void each_piece(const Generation& g, Shadows&& shadows);
    template <class Record> void until_done(Record&& record);
    std::optional<std::uint32_t> find_hits(const Generation& g);
    std::optional<RayCounters> shade_hits(const Generation& hits);
    bool make_walks(std::uint32_t count);
    void add(const RayCounters& c);
    void gather_and_film(const Tile& tile, gpu::Image& image);
    RayPush push_for(const Generation& g) const;
    gpu::Bindings with_structure(gpu::Bindings bindings);
    gpu::Bindings with_primitives(gpu::Bindings bindings);
    gpu::Bindings with_meshes(gpu::Bindings bindings);
    void compute(const char* name, RayPass pass, gpu::Bindings bindings, const RayPush& push, std::uint32_t more = 0,
                 std::uint32_t layers = 1);
    RayCounters submit();
    std::uint32_t packets() const;
    std::uint32_t room() const { return std::min(b_.capacity, b_.nodes - next_); }

    RayTracer& t_;
    const RayWork& w_;
    const RayFrame& frame_;
    RayBuffers& b_;
    std::vector<Generation> generations_;
    unsigned now_ = 0;           // which of the two buffers of rays holds this generation
    std::uint32_t next_ = 0;     // node of the first ray of the next generation
    std::uint32_t expected_ = 0; // invocations that must have ended
};

gpu::Groups groups_of(std::uint32_t invocations, std::uint32_t layers = 1) {
    gpu::Groups groups = groups_for(std::max(invocations, 1u));
    groups.z = layers;
    return groups;
}

// Eye rays go together, and so do the shadow rays of what they hit; the others go their own way.
std::uint32_t TileTracer::packets() const {
    const bool together = generations_.size() <= 1 && w_.device.info().subgroup_size == 8 && w_.plan.accel == Structure::bvh;
    return together && !(w_.plan.ray_effects & RAY_COUNT) ? RAY_PACKETS : 0;
}

RayPush TileTracer::push_for(const Generation& g) const {
    RayPush push{};
    push.ambient = frame_.ambient, push.background = frame_.background;
    push.end_light = t_.lights;
    push.count = g.count, push.first = g.first, push.next_first = next_, push.next_capacity = room();
    push.environment = w_.scene.environment;
    push.max_level = w_.plan.depth, push.cutoff = w_.plan.cutoff, push.seed = w_.plan.seed;
    push.spread = static_cast<float>(frame_.view.pixel_angle());
    push.triangle_count = t_.scene.triangle_count, push.sphere_count = t_.scene.sphere_count, push.shape_count = t_.scene.shape_count;
    return push;
}

// With what a walk reads: the structure besides the primitives.
gpu::Bindings TileTracer::with_structure(gpu::Bindings bindings) {
    offer_table(bindings, "nodes", t_.scene.nodes);
    offer_table(bindings, "narrow", t_.scene.narrow);
    if (b_.walks) bindings.emplace_back("Walks", b_.walks);
    return with_primitives(std::move(bindings));
}

// With what tells of a hit how its surface is there.
gpu::Bindings TileTracer::with_meshes(gpu::Bindings bindings) {
    offer_table(bindings, "materials", w_.scene.materials);
    offer_table(bindings, "texels", w_.scene.texels);
    offer_table(bindings, "corners", t_.scene.corners);
    offer_table(bindings, "normals", w_.scene.normals);
    offer_table(bindings, "detail", w_.scene.detail);
    return bindings;
}

gpu::Bindings TileTracer::with_primitives(gpu::Bindings bindings) {
    offer_table(bindings, "triangles", t_.scene.triangles);
    offer_table(bindings, "spheres", t_.scene.spheres);
    offer_table(bindings, "shapes", t_.scene.shapes);
    bindings.emplace_back("Counters", b_.counters);
    return bindings;
}

void TileTracer::compute(const char* name, RayPass pass, gpu::Bindings bindings, const RayPush& push, std::uint32_t more,
                         std::uint32_t layers) {
    w_.recorder.compute(name, pipeline_of(t_, w_, pass, more), bindings, push, groups_of(push.count, layers));
    expected_ += push.count;
}

RayCounters TileTracer::submit() {
    const auto times = w_.recorder.submit_and_wait();
    w_.times.insert(w_.times.end(), times.begin(), times.end());
    RayCounters c{};
    gpu::download(w_.device, b_.counters, std::as_writable_bytes(std::span(&c, 1)));
    CHECK(c.done == expected_, "while tracing rays: the driver left out invocations");
    expected_ = 0;
    return c;
}

// S16: what the eye is inside of, the innermost first.
glm::uvec4 media_around(const RayScene& scene, const glm::vec3& eye) {
    glm::uvec4 media(0);
    const auto around = surfaces_around(scene.media, eye, [](std::uint32_t) { return true; });
    for (std::size_t i = 0; i < std::min<std::size_t>(around.size(), 4); ++i) media[static_cast<int>(i)] = around[i].surface + 1;
    return media;
}

void TileTracer::record_eye(const Tile& tile) {
    const View& view = frame_.view;
    const glm::dmat3 axes = glm::transpose(glm::dmat3(view.view_from_world)); // columns: right, up, back
    const double up = std::tan(view.fov / 2), right = up * view.size.x / view.size.y;
    EyePush push{};
    push.eye = view.eye_in_frame(w_.geometry.frame);
    if (t_.eye != push.eye) t_.eye = push.eye, t_.eye_media = media_around(t_.scene, push.eye);
    push.media = t_.eye_media;
    push.hither = static_cast<float>(view.near * w_.geometry.frame.scale);
    push.corner = glm::vec3(-axes[2] - right * axes[0] + up * axes[1]);
    push.across = glm::vec3(axes[0] * (2 * right / view.size.x));
    push.down = glm::vec3(-axes[1] * (2 * up / view.size.y));
    push.axis = glm::vec3(-axes[2]);
    push.tile_x = tile.x + static_cast<std::uint32_t>(frame_.origin.x), push.tile_y = tile.y + static_cast<std::uint32_t>(frame_.origin.y);
    push.tile_size = tile.packed(), push.count = tile.count(), push.first = tile.x;
    push.shift = frame_.shift, push.cell = frame_.cell, push.seed = w_.plan.seed, push.sample_index = frame_.sample;
    w_.recorder.fill(b_.counters, 0);
    gpu::Bindings bindings{{"NextRays", b_.rays[now_]}, {"Tree", b_.tree}, {"Counters", b_.counters}};
    if (b_.media[now_]) bindings.emplace_back("NextMedia", b_.media[now_]);
    if (frame_.points) offer_table(bindings, "eye_points", *frame_.points);
    const std::uint32_t more = frame_.points ? RAY_LIST : frame_.cell > 0 ? RAY_JITTER : 0;
    w_.recorder.compute("eye-rays", pipeline_of(t_, w_, RayPass::eye, more), bindings, push, groups_of(push.count));
    expected_ += push.count;
}

void TileTracer::record_trace(const Generation& g, std::uint32_t resume) {
    RayPush push = push_for(g);
    push.resume = resume;
    gpu::Bindings bindings = with_structure({{"Hits", b_.hits}, {"HitRays", b_.hit_rays}, {"Tree", b_.tree}});
    offer_table(bindings, "rays", b_.rays[now_]);
    offer_table(bindings, "texels", w_.scene.texels);
    compute("trace", RayPass::trace, std::move(bindings), push, b_.walks ? RAY_RESUME : packets());
}

void TileTracer::record_shade(const Generation& g) {
    gpu::Bindings bindings = with_meshes(with_primitives({{"Points", b_.points}, {"NextRays", b_.rays[1 - now_]}, {"Tree", b_.tree}}));
    offer_table(bindings, "rays", b_.rays[now_]);
    offer_table(bindings, "hits", b_.hits);
    offer_table(bindings, "hit_rays", b_.hit_rays);
    offer_table(bindings, "media", b_.media[now_]);
    if (b_.media[1 - now_]) bindings.emplace_back("NextMedia", b_.media[1 - now_]);
    compute("shade", RayPass::shade, std::move(bindings), push_for(g));
}

void TileTracer::record_shadows(const Generation&, RayPush push, std::uint32_t lights) {
    gpu::Bindings bindings = with_meshes(with_structure({{"Visibility", b_.visibility}}));
    offer_table(bindings, "points", b_.points);
    offer_table(bindings, "lights", w_.scene.lights);
    compute("shadow", RayPass::shadow, std::move(bindings), push,
            b_.walks                                  ? RAY_RESUME
            : w_.plan.ray_effects & RAY_CLEAR_SHADOWS ? 0
                                                      : packets(),
            lights);
}

void TileTracer::record_light(const Generation&, const RayPush& push) {
    gpu::Bindings bindings{{"Tree", b_.tree}, {"Counters", b_.counters}};
    offer_table(bindings, "rays", b_.rays[now_]);
    offer_table(bindings, "hit_rays", b_.hit_rays);
    offer_table(bindings, "points", b_.points);
    offer_table(bindings, "lit", b_.visibility);
    offer_table(bindings, "tree", b_.tree);
    offer_table(bindings, "materials", w_.scene.materials);
    offer_table(bindings, "lights", w_.scene.lights);
    offer_table(bindings, "texels", w_.scene.texels);
    compute("light", RayPass::light, std::move(bindings), push);
}

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
    if (!make_walks(g.count)) return std::nullopt;
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

void TileTracer::gather_and_film(const Tile& tile, gpu::Image& image) {
    gpu::Bindings tree{{"Tree", b_.tree}};
    offer_table(tree, "tree", b_.tree);
    for (auto g = generations_.rbegin(); g != generations_.rend(); ++g)
        if (g->sends)
            w_.recorder.compute("gather", pipeline_of(t_, w_, RayPass::gather), tree, GatherPush{g->first, g->count}, groups_of(g->count));
    gpu::Bindings film = frame_.points ? gpu::Bindings{{"Lattice", *frame_.lattice}} : gpu::Bindings{{"frame", image}};
    offer_table(film, "tree", b_.tree);
    if (frame_.points) offer_table(film, "eye_points", *frame_.points);
    w_.recorder.compute("film", pipeline_of(t_, w_, frame_.points ? RayPass::film_points : RayPass::film), film,
                        FilmPush{tile.x, tile.y, tile.packed(), tile.count()}, groups_of(tile.count()));
}

void TileTracer::warm_up(gpu::Image& image) {
    w_.recorder.fill(b_.counters, 0);
    const Tile nothing{frame_.area.offset.x, frame_.area.offset.y, 0, 0};
    record_eye(nothing);
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
    record_eye(tile);
    for (std::size_t i = 0; i < generations_.size(); ++i) {
        const Generation g = generations_[i];
        if (w_.stopped()) return true;
        if (!run_generation(g)) return false;
    }
    gather_and_film(tile, image);
    return true;
}

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
    b.capacity = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(pixels, 4096, kCapacity));
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
    b.tree = table("ray-tree", std::uint64_t{b.nodes} * sizeof(RayNode));
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
