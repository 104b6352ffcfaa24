// sRGB, eight bits and the census of non-finite values: LI-8.
#include "kernel_test.h"

#include <algorithm>
#include <cmath>

namespace lightbench::kernels {

TEST_F(Kernel, SrgbEncode) {
    expect_rows(device, "srgb_encode");
}

TEST_F(Kernel, Quantize8) {
    expect_rows(device, "quantize8");
    const KernelRun run = run_row(device, row_of("quantize8"), kMillion, 2);
    for (std::size_t i = 0; i < run.inputs.count(); ++i) ASSERT_EQ(run.result(i)[0], std::floor(run.result(i)[0]));
}

TEST_F(Kernel, NonFinite) {
    const Inputs axis = special_values();
    const Inputs in = random_bits(kMillion, 4, 1) + axis * axis * axis * axis;
    const KernelRun run = run_kernel(device, "non_finite", in, 2);
    const auto any_bad = [](std::span<const float> c) {
        return std::ranges::all_of(c, [](float x) { return std::isfinite(x); }) ? 0.0 : 1.0;
    };
    const auto first_good = [](std::span<const float> c) { return std::isfinite(c[0]) ? 1.0 : 0.0; };
    expect_within(run, {any_bad, any_bad}, Bound::exact());
    expect_within(run, {first_good, first_good}, Bound::exact(),
                  [](std::span<const float>, std::span<const float> out) { return static_cast<double>(out[1]); });
}

} // namespace lightbench::kernels
