// sRGB, eight bits and the census of non-finite values: LI-8.
#include "kernel_test.h"

#include <algorithm>
#include <cmath>

namespace lightbench::kernels {

namespace {

template <class T> T clamp_unit(T x) {
    return x > 0 ? (x < 1 ? x : T(1)) : T(0); // NaN: 0
}

template <class T> T encoded(T x) {
    using std::pow;
    const T c = clamp_unit(x);
    return c <= static_cast<double>(0.0031308f) ? T(c * 12.92) : T(1.055 * pow(c, T(1) / T(2.4)) - 0.055);
}

// All 65 536 values of 16 bits, every tie of 8 bits with its neighbours, and what does not belong.
Inputs table() {
    Inputs in = grid(0, 1, 65536) + special_values();
    for (int k = 0; k < 255; ++k) in = in + near(static_cast<float>((k + 0.5) / 255), 4);
    return in;
}

Inputs random_unit(unsigned seed) {
    return generate(kMillion, 1, seed, [](Random& random, std::span<float> x) { x[0] = static_cast<float>(uniform(random, 0, 1)); });
}

const Bound kHalfStep = Bound::absolute(0.5 + 1e-4);

} // namespace

TEST_F(Kernel, SrgbEncode) {
    const Oracle curve = oracle([](auto in) { return encoded(in[0]); });
    for (unsigned seed : seeds()) {
        const Inputs in = table() + random_unit(seed) + log_grid(1e-6, 1, 100000) + near(0.0031308f, 100);
        expect_within(run_kernel(device, "srgb_encode", in), curve, Bound::absolute(5 * kU));
    }
}

TEST_F(Kernel, Quantize8) {
    const Oracle steps = oracle([](auto in) {
        using T = std::remove_cvref_t<decltype(in[0])>;
        return T(clamp_unit(in[0]) * 255);
    });
    for (unsigned seed : seeds()) {
        const KernelRun run = run_kernel(device, "quantize8", table() + random_unit(seed), 2);
        expect_within(run, steps, kHalfStep);
        for (std::size_t i = 0; i < run.inputs.count(); ++i) ASSERT_EQ(run.result(i)[0], std::floor(run.result(i)[0]));
    }
}

// The whole way of a channel: encoded, then rounded.
TEST_F(Kernel, Quantize8OfSrgb) {
    const Oracle steps = oracle([](auto in) {
        using T = std::remove_cvref_t<decltype(in[0])>;
        return T(encoded(in[0]) * 255);
    });
    const auto second = [](std::span<const float>, std::span<const float> out) { return static_cast<double>(out[1]); };
    for (unsigned seed : seeds()) expect_within(run_kernel(device, "quantize8", table() + random_unit(seed), 2), steps, kHalfStep, second);
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
