// Hemi-cubes a second: a room with a crowd of tessellated boxes, of about 5 000 and 50 000 elements, by 64, 128 and 256 pixels, by rays and
// drawn; with and without the sum is told by the passes' own times. Batches of 16.
// Run interleaved: bench --benchmark_filter=hemicubes --benchmark_enable_random_interleaving=true --benchmark_repetitions=5
// --benchmark_report_aggregates_only=true
#include "../images/patch_grids.h"

#include "gpu/recorder.h"
#include "render/radiosity/hemicube.h"

#include <benchmark/benchmark.h>
#include <ctime>
#include <fmt/format.h>
#include <map>
#include <memory>

namespace lightbench {
namespace {

constexpr unsigned kBatch = 16;

gpu::Device& device() {
    static gpu::Device opened = gpu::Device::open();
    return opened;
}

// The outside of [0, 1]^3, moved and scaled.
void add_box(PatchMesh& mesh, const glm::dvec3& o, double size, unsigned n) {
    const glm::dvec3 x(size, 0, 0), y(0, size, 0), z(0, 0, size);
    add_grid(mesh, {o, y, x, n, n, n});
    add_grid(mesh, {o + z, x, y, n, n, n});
    add_grid(mesh, {o, z, y, n, n, n});
    add_grid(mesh, {o + x, y, z, n, n, n});
    add_grid(mesh, {o, x, z, n, n, n});
    add_grid(mesh, {o + y, z, x, n, n, n});
}

// Half of the elements are walls, half are 27 boxes. Each is two triangles.
PatchMesh room(unsigned elements) {
    const auto wall = static_cast<unsigned>(std::lround(std::sqrt(elements / 12.0)));
    const auto face = std::max(1u, static_cast<unsigned>(std::lround(std::sqrt(elements / 12.0 / 27.0))));
    PatchMesh mesh = closed_box(wall, 4);
    for (unsigned i = 0; i < 27; ++i)
        add_box(mesh, glm::dvec3(-0.7 + 0.55 * (i % 3), -0.72 + 0.53 * (i / 3 % 3), -0.69 + 0.57 * (i / 9)), 0.17 + 0.01 * (i % 5), face);
    return mesh;
}

struct Prepared {
    PatchMesh mesh;
    std::unique_ptr<Hemicubes> cubes;
    gpu::Buffer rows, chosen;
    gpu::Recorder recorder{device()};
    gpu::Timings times;

    Prepared(unsigned elements, const HemicubeRequest& request) : mesh(room(elements)) {
        cubes = std::make_unique<Hemicubes>(device(), mesh, request);
        rows = cubes->make_rows();
        std::vector<std::uint32_t> patches;
        for (unsigned i = 0; i < kBatch; ++i) patches.push_back(static_cast<std::uint32_t>(i * mesh.patches.size() / kBatch));
        chosen = gpu::make_filled_buffer<std::uint32_t>(device(), "chosen", patches, vk::BufferUsageFlagBits::eStorageBuffer);
        batch(); // compiles
    }

    void batch() {
        cubes->record(recorder, chosen, rows);
        times = recorder.submit_and_wait();
    }
};

void hemicubes(benchmark::State& state, const std::string& name, unsigned elements, const HemicubeRequest& request) {
    static std::map<std::string, std::unique_ptr<Prepared>> kept;
    auto& prepared = kept[name];
    if (!prepared) prepared = std::make_unique<Prepared>(elements, request);
    std::map<std::string, double> passes;
    const std::clock_t before = std::clock(); // of all threads: what others do on the machine does not count
    for (auto _ : state) {
        prepared->batch();
        for (const gpu::PassTime& t : prepared->times) passes[t.name] += t.milliseconds;
    }
    const double cpu = 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    prepared->cubes->check();
    const double cubes = static_cast<double>(state.iterations()) * kBatch;
    state.counters["hemicubes"] = benchmark::Counter(cubes, benchmark::Counter::kIsRate);
    state.counters["cpu_ms"] = cpu / cubes;
    for (const auto& [pass, milliseconds] : passes) state.counters[pass + "_ms"] = milliseconds / cubes;
    state.counters["elements"] = static_cast<double>(prepared->mesh.elements.size());
}

const bool kRegistered = [] {
    for (unsigned elements : {2500u, 5000u, 25000u, 50000u})
        for (unsigned pixels : {64u, 128u, 256u})
            for (HemicubeWay way : {HemicubeWay::rays, HemicubeWay::raster})
                for (bool near : {false, true}) {
                    if (near && (way == HemicubeWay::raster || pixels != 64)) continue;
                    const std::string name = fmt::format("hemicubes/{}/{}/{}{}", way == HemicubeWay::rays ? "rays" : "raster", elements,
                                                         pixels, near ? "/near" : "");
                    const HemicubeRequest request{.resolution = pixels, .batch = kBatch, .way = way, .correct_near = near};
                    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) { hemicubes(s, name, elements, request); })
                        ->UseRealTime()
                        ->Unit(benchmark::kMillisecond);
                }
    return true;
}();

} // namespace
} // namespace lightbench
