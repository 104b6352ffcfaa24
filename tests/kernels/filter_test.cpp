// Weights of samples against the bell in double and 60 digits: AA-4.
#include "kernel_test.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

const Oracle kBell = oracle([](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    const T r2 = in[0] * in[0] + in[1] * in[1], end2 = in[2] * in[2], width = 2 * in[3] * in[3];
    return r2 < end2 ? T(exp(-r2 / width) - exp(-end2 / width)) : T(0);
});

} // namespace

TEST_F(Kernel, FilterGaussian) {
    const Inputs shape = only({1.5f}) * only({0.5f}) + only({1}) * only({0.001f, 0.2f, 1000}) + only({3}) * only({0.7f, 2});
    const Inputs offsets = grid(-3.1, 3.1, 200) * grid(-3.1, 3.1, 200) + near(1.5f, 20) * near(0, 2) + only({0}) * only({0});
    expect_within(run_kernel(device, "filter_gaussian", offsets * shape), kBell, Bound::absolute(4 * kU));
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
