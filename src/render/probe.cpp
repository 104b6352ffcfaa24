// Traces one pixel, reads every generation back, and says of each ray what it met and why its branches ended.
#include "render/probe.h"

#include "gpu/recorder.h"
#include "render/probe_terms.h"
#include "render/raster.h"
#include "render/raytrace.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

using glm::dvec3;
using gpu_layout::Ray;
using gpu_layout::RayHit;
using gpu_layout::RayNode;
using gpu_layout::RayPoint;

constexpr const char* kKinds[] = {"eye", "reflected", "refracted", "straight"};
constexpr std::uint32_t kRoom = 512; // pixels a side: buffers as large as an ordinary image's, or trees would fit there and not here

// What the passes left of one generation.
struct Generation {
    TracedGeneration is;
    std::vector<Ray> rays; // by ray, like media and nodes
    std::vector<glm::uvec4> media;
    std::vector<RayNode> nodes;          // before their children are added
    std::vector<std::uint32_t> hit_rays; // the ray of each hit
    std::vector<RayHit> hits;            // by hit, like points
    std::vector<RayPoint> points;
    std::vector<glm::vec4> visibility; // by light, then hit
};

template <class T> std::vector<T> read(gpu::Device& device, gpu::Buffer& buffer, std::size_t count, std::size_t first = 0) {
    std::vector<T> values(buffer ? count : 0);
    if (!values.empty()) gpu::download(device, buffer, std::as_writable_bytes(std::span(values)), first * sizeof(T));
    return values;
}

Generation read_generation(gpu::Device& device, RayBuffers& b, const TracedGeneration& g, std::size_t lights) {
    const std::size_t visible = b.visibility ? b.visibility.size() / sizeof(glm::vec4) : 0;
    return {g,
            read<Ray>(device, b.rays[g.buffer], g.count),
            read<glm::uvec4>(device, b.media[g.buffer], g.count),
            read<RayNode>(device, b.tree, g.count, g.first),
            read<std::uint32_t>(device, b.hit_rays, g.hits),
            read<RayHit>(device, b.hits, g.hits),
            read<RayPoint>(device, b.points, g.hits),
            read<glm::vec4>(device, b.visibility, std::min(lights * g.hits, visible))};
}

// The object number of a primitive.
std::uint32_t object_of(gpu::Device& device, RayScene& s, std::uint32_t ref) {
    const std::uint32_t index = ref & gpu_layout::kRefIndex;
    switch (ref >> gpu_layout::kRefType & 3) {
    case gpu_layout::kTypeTriangle: return read<gpu_layout::RayTriangle>(device, s.triangles, 1, index).front().object;
    case gpu_layout::kTypeSphere: return read<gpu_layout::RaySphere>(device, s.spheres, 1, index).front().object;
    default: return read<gpu_layout::RayShape>(device, s.shapes, 1, index).front().object;
    }
}

struct Teller {
    gpu::Device& device;
    const Scene& scene;
    const RasterGeometry& geometry;
    const Plan& plan;
    RayScene& primitives;

    dvec3 world(const glm::vec3& p) const { return geometry.frame.origin + dvec3(p) / geometry.frame.scale; }
    const Material& material_of(std::uint32_t surface) const { return scene.materials[geometry.surfaces[surface].material]; }
    // Of the h-th hit, which is that of ray i.
    ProbedHit hit_of(const Generation& g, std::uint32_t i, std::size_t h) const;
    std::vector<ProbedStop> stops_of(const Generation& g, std::uint32_t i, std::size_t h, std::span<const std::string> sent) const;
    double outside_over_inside(const Generation& g, std::uint32_t i, std::uint32_t surface) const;
    glm::vec3 opacity_of(const RayPoint& p) const { return plan.effects & EFFECT_TRANSPARENCY ? p.opacity : glm::vec3(1); }
};

ProbedHit Teller::hit_of(const Generation& g, std::uint32_t i, std::size_t h) const {
    const RayPoint& p = g.points[h];
    const Material& m = material_of(p.surface);
    ProbedHit hit;
    hit.object = object_of(device, primitives, g.hits[h].ref), hit.material = geometry.surfaces[p.surface].material;
    hit.distance = double(g.hits[h].t) / geometry.frame.scale;
    hit.position = world(p.position), hit.normal = p.normal, hit.face = plan.ray_effects & RAY_SHADOWS ? p.face : p.normal,
    hit.viewer = -dvec3(g.rays[i].direction);
    hit.kd = plan.effects & EFFECT_ANY_TEXTURE ? p.diffuse : m.diffuse, hit.opacity = opacity_of(p); // written where they are read
    hit.emission = m.emission, hit.ambient = hit.kd * dvec3(scene.environment.ambient);
    dvec3 sum = hit.emission + hit.ambient;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        ProbedLight light = probe_light(scene.lights[k], m, hit);
        const std::size_t at = k * g.is.hits + h;
        if (at < g.visibility.size()) light.shadow = dvec3(glm::vec3(g.visibility[at]));
        light.diffuse *= light.shadow, light.specular *= light.shadow;
        sum += light.diffuse + light.specular;
        hit.lights.push_back(light);
    }
    hit.sum = hit.opacity * sum, hit.device = g.nodes[i].color;
    return hit;
}

// n1 / n2 of the surface that was hit, green. As shaders/raytrace/spawn.glsl keeps its media: the innermost first.
double Teller::outside_over_inside(const Generation& g, std::uint32_t i, std::uint32_t surface) const {
    if (g.media.empty()) return 1;
    const auto index = [&](std::uint32_t medium) { return medium == 0 ? 1.0 : double(material_of(medium - 1).ior.y); };
    std::array<std::uint32_t, 4> inside{g.media[i].x, g.media[i].y, g.media[i].z, g.media[i].w};
    const std::uint32_t medium = surface + 1;
    const bool known = std::ranges::find(inside, medium) != inside.end();
    // Entered here, or left by an eye that began in it: the ratio of one of them is above 1, and only that one can reflect all.
    if (!known) return std::max(index(inside[0]) / index(medium), index(medium) / index(inside[0]));
    const std::uint32_t behind = inside[0] == medium ? inside[1] : inside[0];
    return index(inside[0]) / index(behind);
}

std::vector<ProbedStop> Teller::stops_of(const Generation& g, std::uint32_t i, std::size_t h, std::span<const std::string> sent) const {
    const RayPoint& p = g.points[h];
    const Material& m = material_of(p.surface);
    const bool transmits = m.transmission != glm::vec3(0), deepest = (g.rays[i].level & 0xff) >= plan.depth;
    const glm::vec3 kr = m.reflection.value_or(m.specular);
    const auto followed = [&](const char* kind) { return std::ranges::find(sent, kind) != sent.end(); };
    const std::string depth = fmt::format("the depth of {} is reached", plan.depth),
                      cutoff = fmt::format("its weight is below the cutoff of {:g}", plan.cutoff);
    const double cosine = std::clamp(-glm::dot(dvec3(g.rays[i].direction), dvec3(p.normal)), 0.0, 1.0);
    const bool total = transmits && outside_over_inside(g, i, p.surface) * std::sqrt(1 - cosine * cosine) >= 1 - 1e-6;
    const bool mirrors = kr != glm::vec3(0) || (transmits && (m.fresnel || total));
    const std::string small = deepest ? depth : plan.cutoff > 0 ? cutoff : std::string("its weight is 0");
    const std::string bent = deepest ? depth : total || plan.cutoff <= 0 ? std::string("total internal reflection") : cutoff;
    std::vector<ProbedStop> out;
    if (!followed("reflected")) out.push_back({"reflected", mirrors ? small : "kr = 0"});
    if (!followed("refracted")) out.push_back({"refracted", transmits ? bent : "kt = 0"});
    if (!followed("straight")) out.push_back({"straight", opacity_of(p) == glm::vec3(1) ? "opacity = 1" : cutoff});
    return out;
}

ProbedRay tell(const Teller& teller, const Generation& g, std::uint32_t i, std::span<const RayNode> totals) {
    const Ray& r = g.rays[i];
    const RayNode &node = totals[g.is.first + i], &own = g.nodes[i];
    ProbedRay ray;
    const bool eye = g.is.first == 0; // it is in nobody's sum, so that its node has no weight
    ray.kind = kKinds[eye ? gpu_layout::kRayEye : own.kind & 3], ray.level = r.level & 0xff, ray.weight = eye ? glm::vec3(1) : own.weight;
    ray.origin = teller.world(r.origin), ray.direction = r.direction, ray.radiance = node.color;
    const std::size_t h = static_cast<std::size_t>(std::ranges::find(g.hit_rays, i) - g.hit_rays.begin());
    if (h == g.hit_rays.size()) return ray;
    std::vector<std::string> sent;
    for (std::uint32_t k = 0; k < (own.children & 7); ++k) {
        ray.children.push_back((own.children >> 3) + k);
        sent.emplace_back(kKinds[totals[(own.children >> 3) + k].kind & 3]);
    }
    ray.hit = teller.hit_of(g, i, h), ray.stops = teller.stops_of(g, i, h, sent);
    return ray;
}

} // namespace

Probe probe_pixel(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& asked, const View& view,
                  glm::uvec2 pixel) {
    Plan plan = asked;
    plan.ray_effects &= ~RAY_COUNT, plan.crop.size = glm::uvec2(kRoom);
    GpuScene on_gpu = upload_scene(device, scene, geometry, plan);
    RayTracer tracer = make_ray_tracer(device, scene, geometry, plan);
    gpu::Recorder recorder(device);
    RasterTargets targets = make_targets(device, view.size, 1, "probe");
    gpu::Timings times;
    std::vector<Generation> generations;
    RayWork work{device, recorder, plan, on_gpu, geometry, times, {}};
    work.observe = [&](const TracedGeneration& g) {
        generations.push_back(read_generation(device, tracer.buffers, g, scene.lights.size()));
    };
    const RayFrame frame{view, {pixel, {1, 1}}, glm::vec2(0.5f), 0, 0, scene.environment.ambient, scene.environment.background};
    trace_frame(tracer, work, frame, targets.resolved);
    recorder.submit_and_wait();
    const Generation& last = generations.back();
    const auto totals = read<RayNode>(device, tracer.buffers.tree, last.is.first + last.is.count);
    const Teller teller{device, scene, geometry, plan, tracer.scene};
    Probe probe;
    for (const Generation& g : generations)
        for (std::uint32_t i = 0; i < g.is.count; ++i) probe.rays.push_back(tell(teller, g, i, totals));
    return probe;
}

} // namespace lightbench
