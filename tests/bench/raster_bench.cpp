// Device time of a frame of about 70 000 triangles at 800x600 under one light: each shading beside the driver's floor, a frame that only
// clears and one that writes depth only, with the same view and the same culling.
// Run interleaved: bench --benchmark_enable_random_interleaving=true --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
#include "plan/complete.h"
#include "plan/facts.h"
#include "render/cull.h"
#include "render/raster.h"
#include "render/render.h"
#include "render/shaders.h"
#include "scene/load.h"
#include "shared/effects.h"
#include "shared/layouts.h"

#include <benchmark/benchmark.h>

#include <filesystem>
#include <optional>
#include <stdexcept>

namespace lightbench {
namespace {

// Debian's glmark2-data; a sphere of as many triangles where it is not installed.
constexpr const char* kBunny = "/usr/share/glmark2/models/bunny.obj";

Scene bench_scene() {
    if (std::filesystem::exists(kBunny)) {
        LoadOptions options;
        options.allow_outside = true;
        if (auto loaded = load_scene(kBunny, options); loaded.scene) return *loaded.scene;
    }
    Scene scene;
    scene.materials.resize(1);
    scene.objects.push_back({Sphere{}, 0, 0, 0.5f, 5});
    return scene;
}

gpu::Device& device() {
    static gpu::Device opened = gpu::Device::open();
    return opened;
}

// The scene, planned and uploaded for one shading.
struct Frame {
    Scene scene = bench_scene();
    Plan plan;
    View view;
    RasterGeometry geometry;
    GpuScene on_gpu;
    RasterTargets targets;
    RasterPipelines pipelines;
    RasterVariant variant;
    gpu::Recorder recorder{device()};

    explicit Frame(Shading shading) {
        scene.materials[0].specular = glm::vec3(0.5f);
        Request request;
        request.shading = shading, request.size = {800, 600}, request.output = Output::radiance;
        auto completed = complete(scene, request);
        view = completed.completed.value().view;
        plan = decide(gather_facts(scene), request);
        geometry = tessellate(scene, tessellation_for(plan, view));
        on_gpu = upload_scene(device(), scene, geometry, plan);
        targets = make_targets(device(), plan.size, 1, "radiance");
        variant = {plan.effects, OUTPUT_RADIANCE, 1};
        pipelines = make_raster_pipelines(device(), plan, on_gpu, geometry, variant);
    }
};

double total(const gpu::Timings& timings) {
    double sum = 0;
    for (const auto& t : timings) sum += t.milliseconds;
    return sum;
}

void shaded(benchmark::State& state, Shading shading) {
    static std::map<Shading, Frame> frames;
    Frame& f = frames.try_emplace(shading, shading).first->second;
    std::size_t triangles = 0;
    for (auto _ : state) {
        triangles = record_raster(f.recorder, f.plan, f.on_gpu, f.geometry, f.variant, f.pipelines, f.targets,
                                  {f.view, {}, f.scene.environment.ambient, {}, 0, f.on_gpu.light_count});
        state.SetIterationTime(total(f.recorder.submit_and_wait()) / 1e3);
    }
    state.counters["triangles"] = double(f.geometry.indices.size() / 3);
    state.counters["drawn"] = double(triangles);
}

gpu::GraphicsPipeline depth_pipeline(vk::CullModeFlags cull) {
    gpu::GraphicsDesc desc;
    desc.name = "depth only";
    desc.vertex = find_shader("raster/depth.vert");
    desc.push_size = sizeof(gpu_layout::ShadePush);
    desc.vertex_buffers = {{16, {{0, vk::Format::eR32G32B32Sfloat, 0}}}};
    desc.depth_format = vk::Format::eD32Sfloat;
    desc.cull = cull;
    return gpu::make_graphics(device(), desc);
}

// Depth only, or with `draw` false nothing but the clear of color and depth.
void floor_of_driver(benchmark::State& state, bool draw) {
    static Frame f(Shading::phong);
    static const auto one_sided = depth_pipeline(vk::CullModeFlagBits::eBack), two_sided = depth_pipeline(vk::CullModeFlagBits::eNone);
    gpu::DrawPass pass;
    pass.targets.depth = gpu::DepthTarget{&f.targets.depth, 0.0f, false};
    pass.targets.area = vk::Rect2D{{0, 0}, {800, 600}};
    if (!draw) pass.targets.colors = {{&f.targets.resolved, vk::ClearColorValue(std::array{0.0f, 0.0f, 0.0f, 1.0f}), nullptr, true}};
    if (draw) pass.pipelines = {&one_sided, &two_sided}, pass.vertex_buffers = {&f.on_gpu.positions}, pass.index_buffer = &f.on_gpu.indices;
    gpu_layout::ShadePush push{};
    push.clip_from_frame = f.view.clip_from_frame(f.geometry.frame), push.eye = f.view.eye_in_frame(f.geometry.frame);
    const std::span all(f.geometry.clusters);
    for (auto _ : state) {
        f.recorder.draw("depth", pass, [&](gpu::DrawContext& d) {
            for (const auto* pipeline : pass.pipelines) {
                const auto clusters =
                    pipeline == &one_sided ? all.first(f.geometry.one_sided_clusters) : all.subspan(f.geometry.one_sided_clusters);
                if (clusters.empty()) continue;
                d.use(*pipeline);
                d.push(push);
                for (const auto& run : visible_runs(clusters, push.clip_from_frame, push.eye)) d.draw_indexed(run.count, run.first);
            }
        });
        state.SetIterationTime(total(f.recorder.submit_and_wait()) / 1e3);
    }
}

BENCHMARK_CAPTURE(floor_of_driver, clear_only, false)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(floor_of_driver, depth_only, true)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(shaded, flat, Shading::flat)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(shaded, gouraud, Shading::gouraud)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(shaded, phong, Shading::phong)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);

} // namespace
} // namespace lightbench
