// What each effect of the rasteriser costs: a wall that fills an image of one megapixel, under one light, Phong alone and with one effect
// more; the device milliseconds are milliseconds a megapixel. And transparency of eight layers beside the same eight layers drawn opaque,
// every fragment of them, which no method can beat.
// Run interleaved: bench --benchmark_filter="effect|layers" --benchmark_enable_random_interleaving=true --benchmark_repetitions=7
// --benchmark_report_aggregates_only=true
#include "gpu/check.h"
#include "plan/complete.h"
#include "plan/facts.h"
#include "render/cull.h"
#include "render/layers.h"
#include "render/raster_streams.h"
#include "render/render.h"
#include "render/shaders.h"
#include "scene/tessellate.h"
#include "shared/effects.h"
#include "shared/layouts.h"

#include <benchmark/benchmark.h>

#include <functional>
#include <map>

namespace lightbench {
namespace {

constexpr glm::uvec2 kSize{1024, 1024};

gpu::Device& device() {
    static gpu::Device opened = gpu::Device::open();
    return opened;
}

// Walls of 64 x 64 quads, so that no triangle is larger than a few tiles of a CPU driver, one behind the other.
Scene walls(unsigned count) {
    Scene scene;
    Camera camera;
    camera.position = {0, 0, 10}, camera.fov = 0.2;
    scene.cameras = {camera};
    scene.materials.resize(1);
    scene.materials[0].diffuse = glm::vec3(0.6f), scene.materials[0].specular = glm::vec3(0.4f);
    Light light;
    light.position = {3, 4, 9}, light.intensity = glm::vec3(8);
    scene.lights = {light};
    for (unsigned i = 0; i < count; ++i) {
        const double z = -0.01 * i;
        Object wall;
        wall.shape = Polygon{{{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, 2, z}}, {}};
        wall.subdivide = 6;
        scene.objects.push_back(wall);
    }
    return scene;
}

// 1024 x 512 of noise: a picture that compresses in no cache.
std::uint32_t add_picture(Scene& scene) {
    std::vector<unsigned char> bytes; // Radiance HDR, flat scan lines: the decoder takes it from memory
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 512 +X 1024\n";
    bytes.assign(head.begin(), head.end());
    std::uint32_t state = 1;
    for (int i = 0; i < 1024 * 512; ++i) {
        state = state * 747796405u + 2891336453u;
        for (const unsigned shift : {8u, 16u, 24u}) bytes.push_back(static_cast<unsigned char>(128 + (state >> shift & 127)));
        bytes.push_back(128);
    }
    Picture picture;
    picture.file = "noise.hdr", picture.encoded = std::move(bytes);
    scene.pictures.push_back(std::move(picture));
    return static_cast<std::uint32_t>(scene.pictures.size() - 1);
}

using Change = std::function<void(Scene&)>;

const std::map<std::string, Change>& changes() {
    static const std::map<std::string, Change> rows = {
        {"phong", [](Scene&) {}},
        {"diffuse_only", [](Scene& s) { s.materials[0].specular = glm::vec3(0); }},
        {"gaussian", [](Scene& s) { s.materials[0].model = Model::cook_torrance; }},
        {"beckmann", [](Scene& s) { s.materials[0].model = Model::cook_torrance, s.materials[0].distribution = Distribution::beckmann; }},
        {"checker", [](Scene& s) { s.materials[0].texture.emplace().scale = glm::dvec2(16); }},
        {"texture", [](Scene& s) { s.materials[0].texture.emplace().picture = add_picture(s); }},
        {"texture_spherical",
         [](Scene& s) {
             s.materials[0].texture.emplace().mapping = Mapping::spherical;
             s.materials[0].texture->picture = add_picture(s);
         }},
        {"waves", [](Scene& s) { s.materials[0].bump.emplace().function = BumpFunction::waves; }},
        {"noise", [](Scene& s) { s.materials[0].bump.emplace().function = BumpFunction::noise; }},
        {"height_image", [](Scene& s) { s.materials[0].bump.emplace().picture = add_picture(s); }},
        {"environment",
         [](Scene& s) {
             s.materials[0].environment = 1;
             s.environment.map = {add_picture(s)};
         }},
    };
    return rows;
}

struct Prepared {
    Scene scene;
    Plan plan;
    View view;
    RasterGeometry geometry;
    std::unique_ptr<Renderer> renderer;
    explicit Prepared(Scene made) : scene(std::move(made)) {
        Request request;
        request.size = kSize, request.output = Output::radiance;
        view = complete(scene, request).completed.value().view;
        Facts facts = gather_facts(scene);
        geometry = tessellate(scene, tessellation_for(decide(facts, request), view));
        add_geometry(facts, geometry);
        plan = decide(facts, request);
        renderer = std::make_unique<Renderer>(device(), scene, geometry, plan);
        renderer->render(view);
    }
};

void run(benchmark::State& state, Prepared& prepared) {
    std::map<std::string, double> passes;
    for (auto _ : state) {
        const RenderOutput output = prepared.renderer->render(prepared.view);
        state.SetIterationTime(output.device_milliseconds / 1e3);
        for (const StepTime& step : output.times) passes[step.name] += step.milliseconds;
    }
    for (const auto& [name, milliseconds] : passes)
        if (passes.size() > 1) state.counters[name] = milliseconds / double(state.iterations());
}

void effect(benchmark::State& state, const std::string& name) {
    static std::map<std::string, Prepared> known;
    const auto found = known.find(name);
    if (found != known.end()) return run(state, found->second);
    Scene scene = walls(1);
    changes().at(name)(scene);
    run(state, known.try_emplace(name, std::move(scene)).first->second);
}

Scene panes(float opacity) {
    Scene scene = walls(8);
    scene.materials[0].opacity = glm::vec3(opacity);
    return scene;
}

void layers_translucent(benchmark::State& state) {
    static Prepared prepared(panes(0.5f));
    run(state, prepared);
}

// The same fragments into the color target, every one of them: depth test always, no culling.
void layers_opaque(benchmark::State& state) {
    static Prepared prepared(panes(1));
    static GpuScene scene = upload_scene(device(), prepared.scene, prepared.geometry, prepared.plan);
    static RasterTargets targets = make_targets(device(), kSize, 1, "radiance");
    static const RasterVariant variant{prepared.plan.effects, OUTPUT_RADIANCE, 1};
    static const gpu::GraphicsPipeline pipeline = [] {
        gpu::GraphicsDesc desc;
        desc.name = "always", desc.vertex = find_shader("raster/surface.vert"), desc.fragment = find_shader("raster/surface.frag");
        desc.constants = {{CONSTANT_EFFECTS, variant.effects},
                          {CONSTANT_SHADING, SHADING_PHONG},
                          {CONSTANT_OUTPUT, OUTPUT_RADIANCE},
                          {CONSTANT_LIGHT_COUNT, prepared.plan.light_count},
                          {CONSTANT_FETCH_STORAGE, scene.fetch_storage}};
        desc.push_size = sizeof(gpu_layout::ShadePush);
        for (const VertexStream& stream : vertex_streams(prepared.plan, variant)) desc.vertex_buffers.push_back(stream.layout);
        desc.color_formats = {vk::Format::eR32G32B32A32Sfloat};
        desc.depth_format = vk::Format::eD32Sfloat, desc.depth_compare = vk::CompareOp::eAlways;
        return gpu::make_graphics(device(), desc);
    }();
    static gpu::Recorder recorder(device());
    gpu_layout::ShadePush push{};
    push.clip_from_frame = prepared.view.clip_from_frame(prepared.geometry.frame),
    push.eye = prepared.view.eye_in_frame(prepared.geometry.frame);
    for (auto _ : state) {
        gpu::DrawPass pass;
        pass.pipelines = {&pipeline};
        pass.targets.colors = {{&targets.resolved, vk::ClearColorValue(std::array{0.0f, 0.0f, 0.0f, 1.0f})}};
        pass.targets.depth = gpu::DepthTarget{&targets.depth, 0.0f, false};
        pass.targets.area = vk::Rect2D{{0, 0}, {kSize.x, kSize.y}};
        for (const VertexStream& stream : vertex_streams(prepared.plan, variant)) pass.vertex_buffers.push_back(&(scene.*stream.buffer));
        pass.index_buffer = &scene.indices;
        offer_table(pass.bindings, "materials", scene.materials);
        offer_table(pass.bindings, "lights", scene.lights);
        recorder.draw("always", pass, [&](gpu::DrawContext& d) {
            d.push(push);
            for (const IndexRun& run : visible_runs(prepared.geometry.clusters, push.clip_from_frame, push.eye))
                d.draw_indexed(run.count, run.first);
        });
        double sum = 0;
        for (const auto& time : recorder.submit_and_wait()) sum += time.milliseconds;
        state.SetIterationTime(sum / 1e3);
    }
}

BENCHMARK(layers_opaque)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);
BENCHMARK(layers_translucent)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.3);

// Before main(): Google Benchmark wants its cases registered by then.
const bool kRegistered = [] {
    for (const auto& row : changes())
        benchmark::RegisterBenchmark(fmt::format("effect/{}", row.first).c_str(),
                                     [name = row.first](benchmark::State& state) { effect(state, name); })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.3);
    return true;
}();

} // namespace
} // namespace lightbench
