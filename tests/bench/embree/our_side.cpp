#include "our_side.h"

#include "gpu/check.h"
#include "plan/facts.h"
#include "render/raster.h"

#include <cmath>

namespace lightbench {

using namespace gpu_layout;

namespace {

lightbench::Light point_light(const glm::dvec3& position) {
    lightbench::Light light;
    light.position = position, light.attenuation = Attenuation::none;
    return light;
}

std::vector<Ray> as_rays(std::span<const BenchRay> rays) {
    std::vector<Ray> out;
    for (const BenchRay& r : rays) out.push_back({r.origin, 0, r.direction, kNothing, 0, 1, 1, 0});
    return out;
}

std::vector<RayPoint> as_points(std::span<const BenchRay> rays) {
    std::vector<RayPoint> out;
    for (const BenchRay& r : rays) out.push_back({r.origin, 0, r.normal, 0, r.origin, 0, r.normal, 0, {}, 0, {}, 0});
    return out;
}

template <class T> void put(gpu::Device& device, gpu::Buffer& buffer, const std::vector<T>& values) {
    gpu::upload(device, buffer, std::as_bytes(std::span(values)));
}

template <class T> std::vector<T> get(gpu::Device& device, gpu::Buffer& buffer, std::size_t count) {
    std::vector<T> values(count);
    gpu::download(device, buffer, std::as_writable_bytes(std::span(values)));
    return values;
}

} // namespace

OurScene::OurScene(gpu::Device& device, Scene made, const glm::dvec3& light, glm::uvec2 size)
    : device_(device), scene_(std::move(made)), recorder_(device) {
    scene_.lights = {point_light(light)};
    Request request;
    request.method = Method::raytrace, request.size = size;
    view_ = complete(scene_, request).completed.value().view;
    Facts facts = gather_facts(scene_);
    geometry_ = tessellate(scene_, tessellation_for(decide(facts, request), view_));
    add_geometry(facts, geometry_);
    plan_ = decide(facts, request);
    on_gpu_ = upload_scene(device, scene_, geometry_, plan_);
    tracer_ = make_ray_tracer(device, scene_, geometry_, plan_);
}

gpu::Bindings OurScene::structure(gpu::Bindings bindings) {
    offer_table(bindings, "nodes", tracer_.scene.nodes);
    offer_table(bindings, "narrow", tracer_.scene.narrow);
    offer_table(bindings, "triangles", tracer_.scene.triangles);
    offer_table(bindings, "spheres", tracer_.scene.spheres);
    bindings.emplace_back("Counters", tracer_.buffers.counters);
    return bindings;
}

double OurScene::submit(std::string_view pass, std::uint32_t count, std::uint32_t& hits) {
    double milliseconds = 0;
    for (const gpu::PassTime& time : recorder_.submit_and_wait())
        if (time.name == pass) milliseconds += time.milliseconds;
    const auto counters = get<RayCounters>(device_, tracer_.buffers.counters, 1)[0];
    CHECK(counters.done == count);
    CHECK(counters.unfinished == 0u);
    hits = counters.hits;
    return milliseconds;
}

// The bindings are those of render/ray_records.cpp.
double OurScene::trace_batch(std::span<const BenchRay> rays, Travel travel, float* distances) {
    RayBuffers& b = tracer_.buffers;
    const RayWork work{device_, recorder_, plan_, on_gpu_, geometry_, times_, {}};
    const bool shadow = travel == Travel::shadow, eight = device_.info().subgroup_size == 8;
    const gpu::ComputePipeline& pipeline =
        pipeline_of(tracer_, work, shadow ? RayPass::shadow : RayPass::trace, eight && travel != Travel::alone ? RAY_PACKETS : 0);
    const auto count = static_cast<std::uint32_t>(rays.size());
    RayPush push{};
    push.end_light = 1, push.count = count, push.next_first = count;
    push.triangle_count = tracer_.scene.triangle_count, push.sphere_count = tracer_.scene.sphere_count;
    gpu::Bindings bindings = structure({{"Hits", b.hits}, {"HitRays", b.hit_rays}, {"Tree", b.tree}});
    offer_table(bindings, "rays", b.rays[0]);
    if (shadow) {
        put(device_, b.points, as_points(rays));
        bindings = structure({{"Visibility", b.visibility}});
        offer_table(bindings, "points", b.points);
        offer_table(bindings, "lights", on_gpu_.lights);
    } else {
        put(device_, b.rays[0], as_rays(rays));
    }
    recorder_.fill(b.counters, 0);
    recorder_.compute(shadow ? "shadow" : "trace", pipeline, bindings, push, groups_for(count));
    std::uint32_t hits = 0;
    const double milliseconds = submit(shadow ? "shadow" : "trace", count, hits);
    if (shadow) {
        const auto visible = get<glm::vec4>(device_, b.visibility, count);
        for (std::size_t i = 0; i < count; ++i) distances[i] = visible[i].x > 0 ? kMiss : 0;
        return milliseconds;
    }
    std::fill_n(distances, count, kMiss);
    const auto found = get<RayHit>(device_, b.hits, hits);
    const auto of = get<std::uint32_t>(device_, b.hit_rays, hits);
    for (std::size_t i = 0; i < hits; ++i) distances[of[i]] = found[i].t;
    return milliseconds;
}

double OurScene::trace(std::span<const BenchRay> rays, Travel travel, Distances& distances) {
    distances.resize(rays.size());
    double milliseconds = 0;
    for (std::size_t first = 0; first < rays.size(); first += tracer_.buffers.capacity)
        milliseconds += trace_batch(rays.subspan(first, std::min<std::size_t>(tracer_.buffers.capacity, rays.size() - first)), travel,
                                    distances.data() + first);
    return milliseconds;
}

} // namespace lightbench
