// What a call of each shader function costs on this device, in nanoseconds of one thread for one SIMD group: the loop of
// kernels/shaders/cost.comp with the function, less the loop without.
#include "gpu/buffer.h"
#include "gpu/check.h"
#include "gpu/recorder.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <memory>

std::span<const lightbench::gpu::ShaderCode> kernel_shaders_table();

namespace {

using namespace lightbench;

constexpr std::uint32_t kInvocations = 64; // one work group: one thread of a CPU driver
constexpr std::uint32_t kCalls = 2000;     // an invocation: short, so that some run goes undisturbed; below every loop budget

// The cases of cost.comp, from 0.
// clang-format off
constexpr std::array kFunctions{
    "empty loop", "phong_specular", "pow(max(R.V, 0), n)", "power_one_minus", "pow(1 - s, n)", "lambert", "safe_normalize", "fast_normalize",
    "safe_length", "length", "attenuation_linear", "attenuation_inverse_square", "spot_falloff", "sum_add", "plain +=", "srgb_encode(vec3)",
    "quantize8", "normalize", "cook_torrance_gaussian", "cook_torrance_beckmann", "fresnel_dense(vec3)", "fresnel(vec3)"};
// clang-format on

struct Bench {
    gpu::Device device = gpu::Device::open();
    gpu::Buffer arguments, results;
};

void fill(Bench& bench) {
    std::vector<float> values;
    for (std::uint32_t i = 0; i < kInvocations; ++i)
        for (float x : {0.6f, 0.0f, 0.8f, 0.48f, 0.6f, 0.64f, 0.36f, 0.48f, 0.8f, 20.0f})
            values.push_back(x + 1e-3f * static_cast<float>(i));
    constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;
    bench.arguments = gpu::make_filled_buffer(bench.device, "arguments", std::span<const float>(values), kStorage);
    bench.results = gpu::make_buffer(bench.device, "results", kInvocations * 2 * sizeof(float), kStorage);
}

double nanoseconds(Bench& bench, const gpu::ComputePipeline& pipeline) {
    gpu::Recorder recorder(bench.device);
    recorder.compute("cost", pipeline, {{"Arguments", bench.arguments}, {"Results", bench.results}}, kCalls, {1});
    const double milliseconds = recorder.submit_and_wait().at(0).milliseconds;
    CHECK(gpu::download_all<float>(bench.device, bench.results)[1] == static_cast<float>(kCalls));
    const std::uint32_t groups = kInvocations / bench.device.info().subgroup_size;
    return milliseconds * 1e6 / (kCalls * groups);
}

gpu::ComputePipeline pipeline_of(Bench& bench, std::uint32_t function) {
    const auto table = kernel_shaders_table();
    const auto code = std::ranges::find(table, "cost.comp", &gpu::ShaderCode::name);
    CHECK(code != table.end());
    gpu::ComputePipeline pipeline = gpu::make_compute(bench.device, *code, {{0, function}}, sizeof(kCalls));
    nanoseconds(bench, pipeline); // the first dispatch compiles
    return pipeline;
}

void run(benchmark::State& state, Bench& bench, std::uint32_t function) {
    const gpu::ComputePipeline pipeline = pipeline_of(bench, function), empty = pipeline_of(bench, 0);
    double least = 1e30, least_empty = 1e30; // what else the machine does only adds
    for (auto _ : state) {
        const double with = nanoseconds(bench, pipeline);
        least = std::min(least, with);
        least_empty = std::min(least_empty, nanoseconds(bench, empty));
        state.SetIterationTime(with * 1e-9 * kCalls);
    }
    state.counters["ns_per_group"] = function == 0 ? least : least - least_empty;
}

// Before main(): Google Benchmark wants its cases registered by then.
const bool kRegistered = [] {
    const auto bench = std::make_shared<std::unique_ptr<Bench>>();
    for (std::uint32_t function = 0; function < kFunctions.size(); ++function)
        benchmark::RegisterBenchmark(fmt::format("kernel/{}", kFunctions[function]).c_str(),
                                     [=](benchmark::State& state) {
                                         if (!*bench) {
                                             *bench = std::make_unique<Bench>();
                                             fill(**bench);
                                         }
                                         run(state, **bench, function);
                                     })
            ->UseManualTime()
            ->Iterations(100);
    return true;
}();

} // namespace
