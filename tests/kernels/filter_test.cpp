// Weights of samples against the bell in double and 60 digits: AA-4.
#include "kernel_test.h"

namespace lightbench::kernels {

TEST_F(Kernel, FilterGaussian) {
    expect_rows(device, "filter_gaussian");
}

// No lobes below 0, nothing from the radius on, no step there.
TEST_F(Kernel, FilterGaussianEnds) {
    const Inputs shape = only({1.5f}) * only({0.5f});
    const KernelRun rim =
        run_kernel(device, "filter_gaussian", near(1.5f, 100) * only({0}) * shape + near(1.0606601f, 100) * near(1.0606601f, 9) * shape);
    expect_within(rim, constant(0), Bound::absolute(64 * kU));
    expect_within(rim, constant(0), Bound::exact(), [](std::span<const float> in, std::span<const float> out) {
        const double r2 = static_cast<double>(in[0]) * static_cast<double>(in[0]) + static_cast<double>(in[1]) * static_cast<double>(in[1]);
        return out[0] < 0 || (r2 > 2.25 * (1 + 4 * kU) && out[0] > 0) ? 1 : 0;
    });
}

} // namespace lightbench::kernels
