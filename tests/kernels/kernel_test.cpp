// How kernel tests run kernels and the rows of the program.
#include "kernel_test.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

std::span<const lightbench::gpu::ShaderCode> kernel_shaders_table();

namespace lightbench::kernels {

namespace {

void expect_claim(const KernelRun& run, const Row& row, const Claim& claim) {
    const Verdict verdict = judge(run, claim);
    EXPECT_TRUE(verdict.holds) << row.function << ", " << row.domain << ", " << claim.what << ": " << verdict.message;
    if (verdict.holds) fmt::print("{}: {}\n", claim.what, verdict.message);
}

} // namespace

std::vector<unsigned> seeds() {
    const char* wanted = std::getenv("LIGHTBENCH_LONG_TESTS");
    if (wanted && std::string_view(wanted) == "1") return {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    return {1};
}

const gpu::ShaderCode& find_any_kernel(std::string_view name) {
    const std::span<const gpu::ShaderCode> table = kernel_shaders_table();
    const auto found = std::ranges::find(table, fmt::format("{}.comp", name), &gpu::ShaderCode::name);
    return found == table.end() ? find_kernel(name) : *found;
}

KernelRun run_kernel(gpu::Device& device, const std::string& name, Inputs inputs, std::size_t result_arity, const Words& words) {
    return run_kernel(device, find_any_kernel(name), std::move(inputs), result_arity, words);
}

void expect_within(const KernelRun& run, const Oracle& oracle, const Bound& bound, const Measure& measure) {
    const Verdict verdict = judge(run, oracle, bound, measure);
    EXPECT_TRUE(verdict.holds) << verdict.message;
    if (verdict.holds) fmt::print("{}\n", verdict.message);
}

void expect_claims(const KernelRun& run, std::string_view function) {
    const Row row = row_of(function);
    for (const Claim& claim : row.claims) expect_claim(run, row, claim);
}

void expect_rows(gpu::Device& device, std::string_view function) {
    std::size_t rows = 0;
    for (const Row& row : all_rows())
        for (unsigned seed : seeds()) {
            if (row.function != function) continue;
            const KernelRun run = run_row(device, row, kMillion, seed);
            for (const Claim& claim : row.claims) expect_claim(run, row, claim);
            ++rows;
        }
    EXPECT_GT(rows, 0u) << function;
}

} // namespace lightbench::kernels
