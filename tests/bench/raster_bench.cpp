// Device time of a frame of about 70 000 triangles at 800x600 under one light: each shading beside the driver's floor, a frame that only
// clears, one that writes depth only, and one that also writes a constant color, with the same view and the same culling.
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

std::span<const lightbench::gpu::ShaderCode> bench_shaders_table();

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

enum class Floor { clear, depth, color };

gpu::GraphicsPipeline floor_pipeline(vk::CullModeFlags cull, vk::Format color) {
    gpu::GraphicsDesc desc;
    desc.name = "floor";
    desc.vertex = find_shader("raster/depth.vert");
    desc.push_size = sizeof(gpu_layout::ShadePush);
    desc.vertex_buffers = {{16, {{0, vk::Format::eR32G32B32Sfloat, 0}}}};
    desc.depth_format = vk::Format::eD32Sfloat;
    desc.cull = cull;
    if (color != vk::Format::eUndefined) desc.fragment = bench_shaders_table().front(), desc.color_formats = {color};
    return gpu::make_graphics(device(), desc);
}

void floor_of_driver(benchmark::State& state, Floor floor, vk::Format format) {
    static Frame f(Shading::phong);
    const bool draw = floor != Floor::clear;
    const vk::Format written = floor == Floor::color ? format : vk::Format::eUndefined;
    const auto one_sided = floor_pipeline(vk::CullModeFlagBits::eBack, written),
               two_sided = floor_pipeline(vk::CullModeFlagBits::eNone, written);
    gpu::Image color = gpu::make_image(device(), "floor", {800, 600}, format, vk::ImageUsageFlagBits::eColorAttachment);
    gpu::DrawPass pass;
    pass.targets.depth = gpu::DepthTarget{&f.targets.depth, 0.0f, false};
    pass.targets.area = vk::Rect2D{{0, 0}, {800, 600}};
    if (floor != Floor::depth) pass.targets.colors = {{&color, vk::ClearColorValue(std::array{0.0f, 0.0f, 0.0f, 1.0f}), nullptr, true}};
    if (draw) pass.pipelines = {&one_sided, &two_sided}, pass.vertex_buffers = {&f.on_gpu.positions}, pass.index_buffer = &f.on_gpu.indices;
    gpu_layout::ShadePush push{};
    push.clip_from_frame = f.view.clip_from_frame(f.geometry.frame), push.eye = f.view.eye_in_frame(f.geometry.frame);
    const std::span all(f.geometry.clusters);
    for (auto _ : state) {
        f.recorder.draw("floor", pass, [&](gpu::DrawContext& d) {
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

constexpr vk::Format kRadiance = vk::Format::eR32G32B32A32Sfloat;
BENCHMARK_CAPTURE(floor_of_driver, clear_only, Floor::clear, kRadiance)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(floor_of_driver, depth_only, Floor::depth, kRadiance)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(floor_of_driver, constant, Floor::color, kRadiance)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(floor_of_driver, constant_8_bits, Floor::color, vk::Format::eR8G8B8A8Unorm)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->MinTime(0.3);
BENCHMARK_CAPTURE(shaded, flat, Shading::flat)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(shaded, gouraud, Shading::gouraud)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK_CAPTURE(shaded, phong, Shading::phong)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);

} // namespace
} // namespace lightbench
