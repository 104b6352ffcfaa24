// The laws of attenuation against their formulas: AT-1, AT-2, AT-3.
#include "kernel_test.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

// 1 where the result is finite and not negative.
double sound(std::span<const float>, std::span<const float> out) {
    return std::isfinite(out[0]) && out[0] >= 0 ? 1 : 0;
}

// Every magnitude of distance that a float can hold, infinity too.
Inputs distances() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    return only({0, -0.0f, 1e-45f, 1e-40f, 1.2e-38f, 5e-20f, 1.8e19f, 1.9e19f, 3e19f, kFloatMax}) + log_grid(1e-37, 3e38, 100000) +
           only({kInfinity});
}

// Least-squares slope of log(result) over log(distance).
double log_log_slope(const KernelRun& run) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const double n = static_cast<double>(run.inputs.count());
    for (std::size_t i = 0; i < run.inputs.count(); ++i) {
        const double x = std::log(static_cast<double>(run.inputs[i][0])), y = std::log(static_cast<double>(run.result(i)[0]));
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

} // namespace

TEST_F(Kernel, AttenuationLinear) {
    expect_rows(device, "attenuation_linear");
}

TEST_F(Kernel, AttenuationLinearIsFinite) {
    const Inputs in = distances() * only({0, 1e-40f, 1e-18f, 1, kFloatMax});
    expect_within(run_kernel(device, "attenuation_linear", in), constant(1), Bound::exact(), sound);
}

TEST_F(Kernel, AttenuationInverseSquare) {
    expect_rows(device, "attenuation_inverse_square");
}

TEST_F(Kernel, AttenuationInverseSquareIsFinite) {
    expect_within(run_kernel(device, "attenuation_inverse_square", distances()), constant(1), Bound::exact(), sound);
}

// Bad distances are seen by the census, not turned into light.
TEST_F(Kernel, AttenuationKeepsNaN) {
    const Oracle nan = constant(static_cast<double>(kNaN));
    expect_within(run_kernel(device, "attenuation_linear", only({kNaN}) * only({0, 1, 1e30f})), nan, Bound::exact());
    expect_within(run_kernel(device, "attenuation_linear", only({0, 1, 1e30f}) * only({kNaN})), nan, Bound::exact());
    expect_within(run_kernel(device, "attenuation_inverse_square", only({kNaN})), nan, Bound::exact());
}

TEST_F(Kernel, InverseSquareSlope) {
    const KernelRun run = run_kernel(device, "attenuation_inverse_square", log_grid(0.01, 1000, 1000));
    EXPECT_EQ(run.missing, 0u);
    EXPECT_NEAR(log_log_slope(run), -2, 1e-6);
}

// I(d) / I(0) is d0 / (d + d0), whatever the unit of d0.
TEST_F(Kernel, LinearRatio) {
    for (float d0 : {0.001f, 1.0f, 300.0f}) {
        const KernelRun run = run_kernel(device, "attenuation_linear", (only({0}) + log_grid(1e-3, 1e3, 999)) * only({d0}));
        const double at_light = static_cast<double>(run.result(0)[0]);
        const Oracle ratio = oracle([](auto in) { return in[1] / (in[0] + in[1]); });
        expect_within(run, ratio, Bound::relative(8 * kU),
                      [=](std::span<const float>, std::span<const float> out) { return static_cast<double>(out[0]) / at_light; });
    }
}

} // namespace lightbench::kernels
