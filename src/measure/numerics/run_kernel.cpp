// One dispatch for every 2^20 tuples: work per invocation is bounded, buffers stay below every device's storage range.
#include "measure/numerics/run_kernel.h"

#include "gpu/buffer.h"
#include "gpu/check.h"
#include "gpu/recorder.h"
#include "shared/effects.h"

#include <algorithm>

std::span<const lightbench::gpu::ShaderCode> numerics_shaders_table();

namespace lightbench::kernels {

namespace {

constexpr std::size_t kTuplesADispatch = 1u << 20;
constexpr std::uint32_t kGroup = 64; // invocations, as in kernel.glsl

struct Push {
    std::uint32_t count, arguments, results;
};

void check_flags(KernelRun& run, std::span<const std::uint32_t> flags, std::size_t first) {
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i] != i + 1 && run.missing++ == 0) run.first_missing = first + i;
}

void run_part(gpu::Device& device, const gpu::ComputePipeline& pipeline, KernelRun& run, gpu::Buffer& words, std::size_t first,
              std::size_t count) {
    constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;
    const std::span<const float> arguments(run.inputs.values.data() + first * run.inputs.arity, count * run.inputs.arity);
    gpu::Buffer in = gpu::make_filled_buffer(device, "arguments", arguments, kStorage);
    gpu::Buffer out = gpu::make_buffer(device, "results", count * run.arity * sizeof(float), kStorage);
    gpu::Buffer flags = gpu::make_buffer(device, "flags", count * sizeof(std::uint32_t), kStorage);
    gpu::Recorder recorder(device);
    recorder.fill(flags, 0);
    const Push push{static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(run.inputs.arity), static_cast<std::uint32_t>(run.arity)};
    gpu::Bindings bindings{{"Arguments", in}, {"Results", out}, {"Flags", flags}};
    if (words) bindings.insert(bindings.end(), {{"texels", words}, {"texels_storage", words}});
    recorder.compute(run.kernel, pipeline, bindings, push, {(push.count + kGroup - 1) / kGroup});
    recorder.submit_and_wait();
    const std::vector<float> results = gpu::download_all<float>(device, out);
    run.results.insert(run.results.end(), results.begin(), results.end());
    check_flags(run, gpu::download_all<std::uint32_t>(device, flags), first);
}

} // namespace

const gpu::ShaderCode& find_kernel(std::string_view name) {
    const std::span<const gpu::ShaderCode> table = numerics_shaders_table();
    const std::string file = std::string(name) + ".comp";
    const auto found = std::ranges::find(table, file, &gpu::ShaderCode::name);
    CHECK(found != table.end(), "no kernel {}", file);
    return *found;
}

KernelRun run_kernel(gpu::Device& device, const gpu::ShaderCode& code, Inputs inputs, std::size_t result_arity, const Words& words) {
    gpu::Buffer table;
    if (!words.empty()) {
        table = gpu::make_texel_buffer(device, "texels", words.size() * sizeof(words[0]));
        gpu::upload(device, table, std::as_bytes(std::span(words)));
    }
    const gpu::Constants constants{{CONSTANT_FETCH_STORAGE, table && !table.as_texel() ? FETCH_TEXELS : 0u}};
    const gpu::ComputePipeline pipeline = gpu::make_compute(device, code, constants, sizeof(Push));
    KernelRun run{std::string(code.name.substr(0, code.name.rfind('.'))), std::move(inputs), result_arity, {}, 0, 0};
    run.results.reserve(run.inputs.count() * result_arity);
    for (std::size_t first = 0; first < run.inputs.count(); first += kTuplesADispatch)
        run_part(device, pipeline, run, table, first, std::min(kTuplesADispatch, run.inputs.count() - first));
    return run;
}

} // namespace lightbench::kernels
