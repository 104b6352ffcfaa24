// What a structure over many objects is worth: `make spheres` of 10 000, 66 431 and 1 000 000 spheres, every structure, 512x512 and one
// sample a pixel. Tests and steps are counted in a run of its own. Without a structure a square in the middle is traced, and its time
// scaled by the rays of the whole image.
// Run: structures_bench [SPHERES...]
#include "plan/complete.h"
#include "plan/facts.h"
#include "render/render.h"
#include "scene/make.h"

#include <array>
#include <cstdlib>
#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr unsigned kSide = 512; // pixels
constexpr std::array kStructures{Structure::bvh, Structure::sphere_bvh, Structure::octree, Structure::grid, Structure::none};
constexpr std::array kNames{"none", "bvh", "sphere-bvh", "grid", "octree"}; // by Structure
constexpr double kKnown = 3840; // a grid over more than 10 000 objects: 40 days became 15 minutes

struct Figures {
    double rays = 0, tests = 0, steps = 0; // the last two a ray
    double milliseconds = 0, build = 0;
};

RenderOutput render(gpu::Device& device, Scene scene, const Request& request) {
    const View view = complete(scene, request).completed.value().view;
    Facts facts = gather_facts(scene);
    const RasterGeometry geometry = tessellate(scene, tessellation_for(decide(facts, request), view));
    add_geometry(facts, geometry);
    RenderOptions options;
    options.warm_up = true;
    return Renderer(device, scene, geometry, decide(facts, request)).render(view, options);
}

Figures measure(gpu::Device& device, const Scene& scene, Structure structure, unsigned side) {
    Request request;
    request.method = Method::raytrace, request.accel = structure, request.size = glm::uvec2(kSide);
    request.crop = Rect{glm::uvec2((kSide - side) / 2), glm::uvec2(side)};
    const RenderOutput timed = render(device, scene, request);
    request.count = true;
    const RayStatistics n = render(device, scene, request).rays.value();
    Figures f;
    f.rays = static_cast<double>(n.eye + n.shadow + n.reflected + n.refracted + n.straight);
    f.tests = static_cast<double>(n.triangles + n.spheres + n.boxes + n.balls + n.cones + n.tori) / f.rays;
    f.steps = static_cast<double>(n.nodes + n.voxels) / f.rays;
    f.milliseconds = timed.device_milliseconds;
    f.build = timed.accel ? timed.accel->milliseconds : 0;
    return f;
}

// Seconds on a CPU, and work groups enough for its threads.
unsigned side_without(std::size_t spheres) {
    unsigned side = 128;
    while (side > 16 && double(spheres) * side * side > 1e8) side /= 2;
    return side;
}

void compare(gpu::Device& device, std::size_t spheres) {
    const Scene scene = std::get<Scene>(make_scene("spheres", {{"n", std::to_string(spheres)}}));
    std::array<Figures, kStructures.size()> all;
    double best = 1e300, rays = 0;
    for (const Structure s : kStructures) {
        Figures& f = all[static_cast<std::size_t>(s)];
        const unsigned side = s == Structure::none ? side_without(spheres) : kSide;
        f = measure(device, scene, s, side);
        if (s == Structure::none) f.milliseconds *= rays / f.rays;
        if (s != Structure::none) rays = f.rays, best = std::min(best, f.milliseconds);
        fmt::print("{:>9}  {:<11}{:>12.1f}{:>8.1f}{:>12.0f}{:>14.1f}{}\n", spheres, kNames[static_cast<std::size_t>(s)], f.tests, f.steps,
                   f.build, f.milliseconds, s == Structure::none ? fmt::format("  from {0}x{0} pixels", side) : "");
        std::fflush(stdout);
    }
    const double ratio = all[static_cast<std::size_t>(Structure::none)].milliseconds / best;
    fmt::print("           none / best {:.0f}, {} {:.0f}\n", ratio, ratio > kKnown ? "above" : "below", kKnown);
}

void run(const std::vector<std::size_t>& counts) {
    gpu::Device device = gpu::Device::open();
    fmt::print("{}\n{:>9}  {:<11}{:>12}{:>8}{:>12}{:>14}\n", device.info().version, "spheres", "structure", "tests/ray", "steps",
               "build, ms", "device, ms");
    for (const std::size_t spheres : counts) compare(device, spheres);
}

} // namespace
} // namespace lightbench

int main(int count, char** arguments) try {
    std::vector<std::size_t> spheres;
    for (int i = 1; i < count; ++i) spheres.push_back(static_cast<std::size_t>(std::max(1ll, std::atoll(arguments[i]))));
    lightbench::run(spheres.empty() ? std::vector<std::size_t>{10'000, 66'431, 1'000'000} : spheres);
} catch (const std::exception& e) {
    fmt::print(stderr, "structures_bench: {}\n", e.what());
    return 3;
}
