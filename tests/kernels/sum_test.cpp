// Compensated sums over many dispatches, in every form that the module may take on its way to the driver: LI-6.
#include "kernel_test.h"

#include "gpu/buffer.h"
#include "gpu/check.h"
#include "gpu/recorder.h"
#include "gpu/specialize.h"

#include <algorithm>
#include <set>
#include <spirv-tools/optimizer.hpp>

namespace lightbench::kernels {

namespace {

constexpr std::uint32_t kInvocations = 8;
constexpr std::uint32_t kLoop = 40000; // iterations a dispatch: below the 65 535 after which Mesa 22's lavapipe silently ends loops

struct Push {
    std::uint32_t first, length, terms, shift;
};

// The three channels' sums of every invocation: x, 3 x and -x over the terms, each invocation starting elsewhere.
std::vector<float> run_sum(gpu::Device& device, const gpu::ShaderCode& code, const std::vector<float>& terms) {
    constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;
    const gpu::ComputePipeline pipeline = gpu::make_compute(device, code, {}, sizeof(Push));
    const std::vector<std::uint32_t> zeros(kInvocations * 6);
    gpu::Buffer in = gpu::make_filled_buffer(device, "terms", std::span(terms), kStorage);
    gpu::Buffer state = gpu::make_filled_buffer(device, "state", std::span(zeros), kStorage);
    gpu::Buffer counts = gpu::make_filled_buffer(device, "counts", std::span(zeros).first(kInvocations), kStorage);
    gpu::Buffer out = gpu::make_buffer(device, "results", kInvocations * 3 * sizeof(float), kStorage);
    gpu::Recorder recorder(device);
    const std::uint32_t count = static_cast<std::uint32_t>(terms.size());
    for (std::uint32_t first = 0; first < count; first += kLoop)
        recorder.compute("sum", pipeline, {{"Terms", in}, {"State", state}, {"Counts", counts}, {"Results", out}},
                         Push{first, std::min(kLoop, count - first), count, count / kInvocations}, {1});
    recorder.submit_and_wait();
    for (std::uint32_t n : gpu::download_all<std::uint32_t>(device, counts)) EXPECT_EQ(n, count) << "the loop fell short";
    return gpu::download_all<float>(device, out);
}

// Largest relative error of all invocations and channels, in u.
double worst_error(const std::vector<float>& sums, const std::vector<float>& terms) {
    Precise exact[3] = {0, 0, 0};
    for (float x : terms) exact[0] += Precise(x), exact[1] += Precise(3.0f * x), exact[2] -= Precise(x);
    double worst = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Precise error = abs((Precise(sums[i]) - exact[i % 3]) / exact[i % 3]);
        worst = std::max(worst, static_cast<double>(error) / kU);
    }
    return worst;
}

// One bright term, then faint ones that a plain sum never takes note of.
std::vector<float> stalling(std::size_t count) {
    std::vector<float> terms(count, 0.1f);
    terms[0] = 1e7f;
    return terms;
}

std::vector<float> random_terms(std::size_t count, unsigned seed) {
    return generate(count, 1, seed, [](Random& random, std::span<float> x) { x[0] = static_cast<float>(log_uniform(random, 1e-6, 1)); })
        .values;
}

std::vector<std::uint32_t> optimized(const gpu::ShaderCode& code, bool for_size) {
    const std::vector<std::uint32_t> words = gpu::specialize(code, {});
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    for_size ? optimizer.RegisterSizePasses() : optimizer.RegisterPerformancePasses();
    std::vector<std::uint32_t> result;
    CHECK(optimizer.Run(words.data(), words.size(), &result));
    return result;
}

// Subtractions that no compiler may rearrange: the compensation is made of two of them.
std::size_t bound_subtractions(std::span<const std::uint32_t> words) {
    constexpr std::uint32_t kDecorate = 71, kNoContraction = 42, kSubtract = 131;
    std::set<std::uint32_t> bound;
    std::size_t found = 0;
    for (std::size_t at = 5; at < words.size(); at += words[at] >> 16) {
        const std::uint32_t op = words[at] & 0xffffu;
        if (op == kDecorate && words[at + 2] == kNoContraction) bound.insert(words[at + 1]);
        found += op == kSubtract && bound.contains(words[at + 2]);
    }
    return found;
}

} // namespace

TEST_F(Kernel, SumAdd) {
    expect_rows(device, "sum_add");
}

TEST_F(Kernel, CompensatedSum) {
    const gpu::ShaderCode& code = find_any_kernel("compensated_sum");
    for (const std::vector<float>& terms : {random_terms(10000, 1), random_terms(1000000, 2), stalling(1000000)}) {
        const double worst = worst_error(run_sum(device, code, terms), terms);
        EXPECT_LE(worst, 8) << terms.size() << " terms";
        fmt::print("compensated_sum: {} terms, worst error {:.3g} u\n", terms.size(), worst);
    }
}

// What SPIR-V tools make of it: the same sums, the compensation still there.
TEST_F(Kernel, CompensationSurvivesOptimization) {
    const gpu::ShaderCode& code = find_any_kernel("compensated_sum");
    const std::vector<float> terms = stalling(200000);
    const std::vector<float> plain_way = run_sum(device, code, terms);
    const std::vector<std::uint32_t> modules[] = {gpu::specialize(code, {}), optimized(code, false), optimized(code, true)};
    for (const std::vector<std::uint32_t>& words : modules) {
        EXPECT_EQ(bound_subtractions(words), 2u);
        const std::vector<float> sums = run_sum(device, {"optimized", words}, terms);
        EXPECT_LE(worst_error(sums, terms), 8);
        EXPECT_EQ(sums, plain_way);
    }
}

// The test of the test: without compensation the bound is missed, and the module has no such subtraction.
TEST_F(Kernel, PlainSumIsReported) {
    const gpu::ShaderCode& code = find_any_kernel("plain_sum");
    const std::vector<float> terms = stalling(100000);
    EXPECT_GT(worst_error(run_sum(device, code, terms), terms), 1000);
    EXPECT_EQ(bound_subtractions(gpu::specialize(code, {})), 0u);
}

} // namespace lightbench::kernels
