// Mappings of space to texture coordinates against arc tangents in double: TX-3, TX-4, TX-5.
#include "kernel_test.h"

#include <array>
#include <cmath>

namespace lightbench::kernels {

TEST_F(Kernel, Turns) {
    expect_rows(device, "turns");
}

TEST_F(Kernel, Mappings) {
    expect_rows(device, "map_spherical, map_cylindrical, map_planar");
}

// TX-3: on the axis u is 0; upwards v is 1, downwards 0.
TEST_F(Kernel, PolesAreDefined) {
    const Inputs zeros = only({0.0f, -0.0f});
    const KernelRun run = run_kernel(device, "mapping", zeros * zeros * only({1, 1e-10f, -1, -1e-10f}), 6);
    expect_within(run, oracle([](auto p) { return p[2] > 0 ? 1 : 0; }), Bound::exact(), component(1));
    expect_within(run, constant(0), Bound::exact(), component(0));
}

TEST_F(Kernel, MapGradients) {
    expect_rows(device, "mapping gradients");
    const Row row = row_of("mapping gradients");
    const KernelRun run = run_row(device, row, kMillion / 4, 2);
    for (const auto& [i, value] : {std::pair{9u, 0.0}, {10u, 0.0}, {11u, 0.5}, {12u, 0.5}, {13u, 0.0}, {14u, 0.0}, {15u, 0.0}, {16u, 0.5}})
        expect_within(run, constant(value), Bound::exact(), component(i));
}

// Nearer to the axis than a float can tell, gradients stay below 2^23 over the distance from the middle.
TEST_F(Kernel, MapGradientsAtThePoles) {
    const Inputs little = only({0.0f, -0.0f, 1e-45f, 1e-38f, -1e-30f, 1e-12f, 1e-8f, -1e-7f});
    const KernelRun run = run_kernel(device, "mapping_gradients", little * little * only({1, -1, 0.5f, 0, 1e-20f}), 18);
    const Measure largest = [](std::span<const float> p, std::span<const float> out) {
        double most = 0;
        for (float x : out) most = std::isfinite(x) ? std::max(most, std::abs(static_cast<double>(x))) : 1e30;
        return std::max(0.0, most * std::max(static_cast<double>(std::abs(p[2])), 0x1p-30) / 0x1p23 - 1);
    };
    expect_within(run, constant(0), Bound::exact(), largest);
}

TEST_F(Kernel, WrappedDerivatives) {
    const Inputs in = (grid(-1, 1, 4097) + near(0.5f, 10) + near(-0.5f, 10) + near(0, 10)) * only({0, 0.75f, -3});
    const KernelRun run = run_kernel(device, "wrapped", in, 2);
    expect_within(run, oracle([](auto d) { return d[1]; }), Bound::exact(), component(1));
    const Measure shorter = [](std::span<const float> d, std::span<const float> out) {
        const double whole = static_cast<double>(d[0]) - static_cast<double>(out[0]);
        const double flushed = std::abs(d[0]) < 0x1p-126f ? 0x1p-126 : 0; // denormals count as 0 on some devices
        return std::abs(out[0]) <= 0.5f && std::abs(whole - std::round(whole)) <= flushed ? 0 : 1;
    };
    expect_within(run, constant(0), Bound::exact(), shorter);
}

} // namespace lightbench::kernels
