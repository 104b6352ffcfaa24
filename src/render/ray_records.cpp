// What each pass over rays binds and pushes.
#include "accel/containment.h"
#include "gpu/check.h"
#include "render/raster.h"
#include "render/ray_tiles.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <algorithm>
#include <cmath>

namespace lightbench {

using namespace gpu_layout;

namespace {

gpu::Groups groups_of(std::uint32_t invocations, std::uint32_t layers = 1) {
    gpu::Groups groups = groups_for(std::max(invocations, 1u));
    groups.z = layers;
    return groups;
}

// S16: what the eye is inside of, the innermost first.
glm::uvec4 media_around(const RayScene& scene, const glm::vec3& eye) {
    glm::uvec4 media(0);
    const auto around = surfaces_around(scene.media, eye, [](std::uint32_t) { return true; });
    for (std::size_t i = 0; i < std::min<std::size_t>(around.size(), 4); ++i) media[static_cast<int>(i)] = around[i].surface + 1;
    return media;
}

} // namespace

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

// Eye rays are made where they are traced, unless they must be there before: those through listed points, those that an observer reads whether
// they hit or not, and those of walks that are put down and taken up again.
bool TileTracer::makes_eye_rays() const {
    return generations_.size() <= 1 && !frame_.points && !w_.observe && !b_.walks;
}

bool TileTracer::sums_light() const {
    return w_.output != OUTPUT_NORMAL && w_.output != OUTPUT_DEPTH && w_.output != OUTPUT_OBJECT;
}

std::uint32_t TileTracer::eye_effects() const {
    return frame_.points ? RAY_LIST : frame_.cell > 0 ? RAY_JITTER : 0;
}

EyePush TileTracer::camera_of(const Tile& tile) {
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
    return push;
}

void TileTracer::begin(const Tile& tile) {
    camera_ = camera_of(tile);
    w_.recorder.fill(b_.counters, 0);
    gpu::upload(w_.device, b_.camera, std::as_bytes(std::span(&camera_, 1)));
    if (!makes_eye_rays()) record_eye();
}

void TileTracer::record_eye() {
    gpu::Bindings bindings{{"NextRays", b_.rays[now_]}, {"Counters", b_.counters}};
    if (b_.media[now_]) bindings.emplace_back("NextMedia", b_.media[now_]);
    if (frame_.points) offer_table(bindings, "eye_points", *frame_.points);
    w_.recorder.compute("eye-rays", pipeline_of(t_, w_, RayPass::eye, eye_effects()), bindings, camera_, groups_of(camera_.count));
    expected_ += camera_.count;
}

void TileTracer::record_trace(const Generation& g, std::uint32_t resume) {
    RayPush push = push_for(g);
    push.resume = resume;
    gpu::Bindings bindings = with_structure({{"Hits", b_.hits}, {"HitRays", b_.hit_rays}, {"Tree", b_.tree}});
    offer_table(bindings, "rays", b_.rays[now_]);
    offer_table(bindings, "texels", w_.scene.texels);
    std::uint32_t more = b_.walks ? RAY_RESUME : packets();
    if (makes_eye_rays()) {
        more |= RAY_EYE | eye_effects();
        bindings.emplace_back("Camera", b_.camera);
        bindings.emplace_back("EyeRays", b_.rays[now_]);
        if (b_.media[now_]) bindings.emplace_back("EyeMedia", b_.media[now_]);
    }
    compute("trace", RayPass::trace, std::move(bindings), push, more);
}

void TileTracer::record_shade(const Generation& g) {
    gpu::Bindings bindings =
        with_meshes(with_primitives({{"Points", b_.points}, {"NextRays", b_.rays[1 - now_]}, {"Tree", b_.tree}, {"Camera", b_.camera}}));
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
    if (b_.carries) bindings.emplace_back("Carries", b_.carries);
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

void TileTracer::gather_and_film(const Tile& tile, gpu::Image& image) {
    gpu::Bindings tree{{"Tree", b_.tree}};
    offer_table(tree, "tree", b_.tree);
    for (auto g = generations_.rbegin(); g != generations_.rend(); ++g) {
        const std::uint32_t parts = g->first == 0 ? w_.parts : kAllParts;
        if (g->sends || parts != kAllParts)
            w_.recorder.compute("gather", pipeline_of(t_, w_, RayPass::gather), tree, GatherPush{g->first, g->count, parts},
                                groups_of(g->count));
    }
    if (w_.display) return record_pixels(tile);
    gpu::Bindings film = frame_.points ? gpu::Bindings{{"Lattice", *frame_.lattice}} : gpu::Bindings{{"frame", image}};
    offer_table(film, "tree", b_.tree);
    if (frame_.points) offer_table(film, "eye_points", *frame_.points);
    w_.recorder.compute("film", pipeline_of(t_, w_, frame_.points ? RayPass::film_points : RayPass::film), film,
                        FilmPush{tile.x, tile.y, tile.packed(), tile.count()}, groups_of(tile.count()));
}

void TileTracer::record_pixels(const Tile& tile) {
    Display& d = *w_.display;
    gpu::Bindings bindings{{"Pixels", d.pixels}, {"CensusBlock", d.census}};
    offer_table(bindings, "tree", b_.tree);
    const PixelsPush push{tile.x, tile.y, tile.packed(), tile.count(), d.crop.offset, d.crop.size.x, std::exp2(d.exposure)};
    w_.recorder.compute("display", pipeline_of(t_, w_, RayPass::film_pixels), bindings, push, groups_of(tile.count()));
    d.shown += tile.count();
}

} // namespace lightbench
