// The fixture of kernel tests: a device with validation switched on, whose every message fails the test; and the rows of the program's
// table of bounds (measure/numerics/rows.h), run over more inputs than the program does.
#pragma once

#include "measure/numerics/rows.h"

#include <gtest/gtest.h>

namespace lightbench::kernels {

constexpr std::size_t kMillion = 1u << 20; // random tuples for each seed

// How often the random families are drawn, each time with another seed: once; ten times under LIGHTBENCH_LONG_TESTS=1.
std::vector<unsigned> seeds();

// A kernel of the program (shaders/numerics/) or of the tests (tests/kernels/shaders/), by its name without .comp.
const gpu::ShaderCode& find_any_kernel(std::string_view name);
KernelRun run_kernel(gpu::Device& device, const std::string& name, Inputs inputs, std::size_t result_arity = 1, const Words& words = {});

// Fails the test if the verdict does; prints it either way, for the record of what was reached.
void expect_within(const KernelRun& run, const Oracle& oracle, const Bound& bound, const Measure& measure = first_float);

// Every claim of the first row of a function, on a run of its kernel over other inputs.
void expect_claims(const KernelRun& run, std::string_view function);
inline void expect_claims(gpu::Device& device, std::string_view function, Inputs inputs) {
    const Row row = row_of(function);
    expect_claims(run_kernel(device, row.kernel, std::move(inputs), row.results), function);
}

// All rows of a function over their domains, for every seed.
void expect_rows(gpu::Device& device, std::string_view function);

class Kernel : public testing::Test {
  protected:
    void TearDown() override { EXPECT_EQ(device.validation_messages(), std::vector<std::string>{}); }
    gpu::Device device = gpu::Device::open({.choice = "", .validation = true});
};

} // namespace lightbench::kernels
