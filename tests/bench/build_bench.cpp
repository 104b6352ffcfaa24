// What a tree of boxes costs: built on the host by surface area, and on the device along a curve; and what it costs to trace rays through each.
// A bumpy ball in a room, of about so many triangles.
// Run interleaved: bench --benchmark_filter=tree --benchmark_enable_random_interleaving=true --benchmark_repetitions=5
// --benchmark_report_aggregates_only=true
#include "accel/accel.h"
#include "plan/complete.h"
#include "plan/facts.h"
#include "render/device_build.h"
#include "render/render.h"
#include "scene/tessellate.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <numbers>

namespace lightbench {
namespace {

gpu::Device& device() {
    static gpu::Device opened = gpu::Device::open();
    return opened;
}

// 2 n by n quads about the axis, without the poles.
Mesh bumpy_ball(std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t row = 0; row <= n; ++row)
        for (std::uint32_t column = 0; column < 2 * n; ++column) {
            const double u = std::numbers::pi * column / n, v = std::numbers::pi * (0.02 + 0.96 * row / n);
            const double r = 1 + 0.1 * std::sin(9 * u) * std::sin(7 * v) + 0.02 * std::sin(61 * u + 3 * v) * std::sin(53 * v);
            mesh.positions.emplace_back(r * std::sin(v) * std::cos(u), r * std::cos(v), r * std::sin(v) * std::sin(u));
        }
    mesh.face_starts = {0};
    for (std::uint32_t row = 0; row < n; ++row)
        for (std::uint32_t column = 0; column < 2 * n; ++column) {
            const std::uint32_t a = row * 2 * n + column, b = row * 2 * n + (column + 1) % (2 * n);
            for (const std::uint32_t corner : {a, b, b + 2 * n, a, b + 2 * n, a + 2 * n}) mesh.corners.push_back(corner);
            mesh.face_starts.insert(mesh.face_starts.end(), {mesh.face_starts.back() + 3, mesh.face_starts.back() + 6});
        }
    return mesh;
}

Scene ball_in_room(std::uint32_t triangles) {
    Scene scene;
    Camera camera;
    camera.position = {0.5, 1.2, 3.2};
    scene.cameras = {camera};
    scene.materials.resize(1);
    scene.materials[0].diffuse = glm::vec3(0.6f), scene.materials[0].reflection = glm::vec3(0.3f);
    Light light;
    light.position = {2, 3, 2}, light.intensity = glm::vec3(8);
    scene.lights = {light};
    scene.meshes = {bumpy_ball(static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 4.0))))};
    Object ball, floor;
    ball.shape = MeshUse{0};
    floor.shape = Polygon{{{-4, -1.2, 4}, {4, -1.2, 4}, {4, -1.2, -4}, {-4, -1.2, -4}}, {}};
    scene.objects = {ball, floor};
    return scene;
}

struct Prepared {
    Scene scene;
    View view;
    Plan plan;
    RasterGeometry geometry;
    RayPrimitives primitives;

    Prepared(std::uint32_t triangles, TreeBuilder builder) : scene(ball_in_room(triangles)) {
        Request request;
        request.method = Method::raytrace, request.size = {512, 512}, request.output = Output::radiance, request.depth = 3;
        request.accel_parameters.builder = builder;
        view = complete(scene, request).completed.value().view;
        plan = decide(gather_facts(scene), request);
        geometry = tessellate(scene, tessellation_for(plan, view));
        primitives = ray_primitives(scene, geometry);
    }
};

Prepared& prepared(std::uint32_t triangles, TreeBuilder builder) {
    static std::map<std::pair<std::uint32_t, TreeBuilder>, Prepared> all;
    return all.try_emplace({triangles, builder}, triangles, builder).first->second;
}

void tree_host(benchmark::State& state) {
    Prepared& p = prepared(static_cast<std::uint32_t>(state.range(0)), TreeBuilder::host);
    AccelTables tables;
    for (auto _ : state) {
        RayPrimitives primitives = p.primitives;
        tables = build_accel(primitives, {});
        state.SetIterationTime(tables.milliseconds / 1e3);
    }
    state.counters["nodes"] = double(tables.node_count);
    state.counters["depth"] = tables.depth;
}

// Pipelines and buffers are there, as from the second build on.
void tree_device(benchmark::State& state) {
    Prepared& p = prepared(static_cast<std::uint32_t>(state.range(0)), TreeBuilder::device);
    DeviceBuilder builder(device());
    builder.build(p.primitives, 0);
    AccelTables tables;
    std::map<std::string, double> passes;
    for (auto _ : state) {
        DeviceTree tree = builder.build(p.primitives, 0);
        tables = tree.accel;
        passes.clear();
        for (const auto& time : tree.times) passes[time.name] += time.milliseconds;
        state.SetIterationTime(tables.milliseconds / 1e3);
    }
    state.counters["nodes"] = double(tables.node_count);
    state.counters["depth"] = tables.depth;
    for (const auto& [name, milliseconds] : passes) state.counters[name] = milliseconds;
}

void tree_traced(benchmark::State& state, TreeBuilder builder) {
    Prepared& p = prepared(static_cast<std::uint32_t>(state.range(0)), builder);
    Renderer renderer(device(), p.scene, p.geometry, p.plan);
    renderer.render(p.view);
    for (auto _ : state) {
        double milliseconds = 0;
        for (const auto& step : renderer.render(p.view).times)
            if (step.name == "trace" || step.name == "shadow") milliseconds += step.milliseconds;
        state.SetIterationTime(milliseconds / 1e3);
    }
}

#define TREE_SIZES ->Arg(10'000)->Arg(70'000)->Arg(1'000'000)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3)
BENCHMARK(tree_host) TREE_SIZES;
BENCHMARK(tree_device) TREE_SIZES;
BENCHMARK_CAPTURE(tree_traced, host, TreeBuilder::host) TREE_SIZES;
BENCHMARK_CAPTURE(tree_traced, device, TreeBuilder::device) TREE_SIZES;

} // namespace
} // namespace lightbench
