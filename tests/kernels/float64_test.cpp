// The factors of --precision float64 against their formulas: what they err by is the rounding of their results to float, u = 2^-24.
#include "kernel_test.h"

#include "gpu/float64.h"

#include <boost/math/constants/constants.hpp>

namespace lightbench::kernels {

namespace {

class Float64Factors : public Kernel {
  protected:
    void SetUp() override {
        if (!gpu::has_float64(device)) GTEST_SKIP() << "the device has no float64";
    }
};

// The rounding, and a hundredth of it for all that happens in double.
const Bound kRounded = Bound::function([](std::span<const float>, double expected) { return 1.01 * kU * std::abs(expected) + 1.3e-38; });

template <class T> struct Cosines {
    T nl, rv;  // N.L, R.V of unit vectors
    T missing; // 1 - R.V, with its digits
};

template <class T> Cosines<T> cosines(std::span<const T> in) {
    const auto dot = [&](std::size_t a, std::size_t b) { return T(in[a] * in[b] + in[a + 1] * in[b + 1] + in[a + 2] * in[b + 2]); };
    using std::sqrt;
    const T n = sqrt(dot(0, 0)), l = sqrt(dot(3, 3)), v = sqrt(dot(6, 6)), nl = T(dot(0, 3) / (n * l));
    T missing = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const T off = 2 * nl * in[i] / n - in[3 + i] / l - in[6 + i] / v;
        missing += off * off / 2;
    }
    return {nl, T(1 - missing), missing};
}

const auto kPower = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    const Cosines<T> c = cosines<T>(in);
    if (c.nl <= 0 || c.rv <= 0) return T(0);
    using std::log1p;
    const T x = in[9] * log1p(T(-c.missing));
    return x < -87.3 ? T(0) : T(exp(x));
};

// R.V is known to 2^-52 or so in double, here as in the oracle, and the power makes n of that. On the terminator either side is right.
double power_bound(std::span<const float> in, double expected) {
    const std::vector<double> wide(in.begin(), in.end());
    const Cosines<double> c = cosines<double>(wide);
    if (std::abs(c.nl) < 1e-14) return 1;
    if (c.rv < 0.5) return 4 * kU;
    return (1.01 * kU + 0x1p-46 * (1 + wide[9])) * expected + 1.3e-38;
}

const auto kLambert = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    const T nl = cosines<T>(in).nl;
    return nl <= 0 ? T(0) : nl;
};

const auto kInverseSquare = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    return T(1 / (4 * boost::math::constants::pi<T>() * in[0] * in[0]));
};

const auto kFalloff = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    if (in[2] >= in[4]) return T(1);
    if (in[2] <= in[3]) return T(0);
    const T t = (in[2] - in[3]) / (in[4] - in[3]);
    return T(t * t * (3 - 2 * t));
};

// Distances, and cones with an edge of a thousandth or more.
Inputs arrivals(std::size_t count, unsigned seed) {
    return generate(count, 5, seed, [](Random& random, std::span<float> in) {
        for (std::size_t i = 0; i < 2; ++i) in[i] = static_cast<float>(log_uniform(random, 1e-15, 1e15));
        const double outer = uniform(random, -1, 0.99), inner = uniform(random, outer + 0.001, 1);
        in[2] = static_cast<float>(uniform(random, outer - 0.2 * (inner - outer), inner + 0.2 * (inner - outer)));
        in[3] = static_cast<float>(outer), in[4] = static_cast<float>(inner);
    });
}

TEST_F(Float64Factors, OfTheSurface) {
    for (const unsigned seed : seeds()) {
        const KernelRun run = run_kernel(device, "phong_float64", row_of("phong_specular").inputs(kMillion, seed), 2);
        expect_within(run, oracle(kPower), Bound::function(power_bound));
        expect_within(run, oracle(kLambert), Bound::function([](auto, double x) { return 1.01 * kU * x + 1e-14; }), component(1));
    }
}

TEST_F(Float64Factors, OfTheLight) {
    for (const unsigned seed : seeds()) {
        const KernelRun run = run_kernel(device, "arrival_float64", arrivals(kMillion, seed), 3);
        expect_within(run, oracle([](auto in) { return 1 / (in[0] + in[1]); }), kRounded);
        expect_within(run, oracle(kInverseSquare), kRounded, component(1));
        expect_within(run, oracle(kFalloff), Bound::absolute(1.01 * kU), component(2));
    }
}

TEST_F(Float64Factors, KeepNaN) {
    const Oracle nan = constant(static_cast<double>(kNaN));
    const auto up = only({0}) * only({0}) * only({1}), bad = only({kNaN}) * only({0}) * only({1});
    const KernelRun surface = run_kernel(device, "phong_float64", bad * up * up * only({1, 100}) + up * bad * up * only({1, 100}), 2);
    expect_within(surface, nan, Bound::exact());
    expect_within(surface, nan, Bound::exact(), component(1));
    const KernelRun power = run_kernel(device, "phong_float64", up * up * bad * only({1}) + up * up * up * only({kNaN}), 2);
    expect_within(power, nan, Bound::exact());
    const KernelRun light =
        run_kernel(device, "arrival_float64", only({kNaN}) * only({1}) * only({kNaN}) * only({0.5f}) * only({0.75f}), 3);
    for (std::size_t i = 0; i < 3; ++i) expect_within(light, nan, Bound::exact(), component(i));
}

} // namespace
} // namespace lightbench::kernels
