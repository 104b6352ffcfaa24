// Logarithms, exponentials and powers near 1 against double and 60 digits: LI-1's stable form.
#include "kernel_test.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

constexpr double kLeastExponent = static_cast<double>(-87.3f); // below, exp_negative is 0

Inputs random_axis(unsigned seed, double low, double high, bool logarithmic) {
    return generate(kMillion / 2, 1, seed, [=](Random& random, std::span<float> x) {
        x[0] = static_cast<float>(logarithmic ? log_uniform(random, low, high) : uniform(random, low, high));
    });
}

// Where the exponent of 1 - s changes, and where 1 - s loses or keeps its digits.
Inputs turns_of_s() {
    return near(0.29289323f, 100) + near(0.5f, 100) + near(0.64644661f, 100) + near(0.01f, 100) + near(1e-7f, 100) +
           near(5.9604645e-8f, 100) + only({0, 1e-45f, 1e-38f, 0x1.fffffep-1f, 0x1.fffffcp-1f});
}

double x_of(std::span<const float> in) {
    return static_cast<double>(in[1]) * std::log1p(-static_cast<double>(in[0]));
}

// (s, n) -> (1 - s)^n; 0 where it is no normal number.
const Oracle kPower = oracle([](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    using std::log1p;
    const T x = in[1] * log1p(-in[0]);
    return x < kLeastExponent ? T(0) : T(exp(x));
});

// Relative (8 + 2|x|) u, 2.5|x| from s = 0.01 on; about the exponent where results end, either side is right.
const Bound kPowerBound = Bound::function([](std::span<const float> in, double expected) {
    const double x = x_of(in);
    const double about_the_end = std::abs(x - kLeastExponent) < 1e-4 ? 1.3e-38 : 0;
    return (8 + (in[0] < 0.01f ? 2 : 2.5) * std::abs(x)) * kU * expected + about_the_end;
});

} // namespace

TEST_F(Kernel, LogOneMinus) {
    const Oracle log_oracle = oracle([](auto in) {
        using std::log1p;
        return log1p(-in[0]);
    });
    const Bound bound = Bound::function([](std::span<const float> in, double expected) {
        const double flushed = in[0] < 0x1p-126f ? 0x1p-126 : 0; // denormal s counts as 0 on some devices
        return (in[0] < 0.01f ? 1.1 : 2.5) * kU * std::abs(expected) + flushed;
    });
    for (unsigned seed : seeds()) {
        const Inputs in = random_axis(seed, 0, 0.99999994, false) + random_axis(seed, 1e-37, 0.99999994, true) + turns_of_s();
        expect_within(run_kernel(device, "log_one_minus", in), log_oracle, bound);
    }
}

TEST_F(Kernel, LogUnit) {
    for (unsigned seed : seeds()) {
        const Inputs in = random_axis(seed, 0x1p-20, 1, false) + random_axis(seed, 0x1p-126, 1, true) + near(0.70710678f, 100) +
                          near(0.35355339f, 100) + only({1, 0x1p-126f, 0x1.fffffep-1f});
        expect_within(run_kernel(device, "log_unit", in), oracle([](auto x) { return log(x[0]); }), Bound::relative(2.5 * kU));
    }
}

TEST_F(Kernel, ExpNegative) {
    const Oracle exp_oracle = oracle([](auto in) {
        using T = std::remove_cvref_t<decltype(in[0])>;
        return in[0] < kLeastExponent ? T(0) : T(exp(in[0]));
    });
    for (unsigned seed : seeds()) {
        const Inputs in = random_axis(seed, -90, 0, false) + random_axis(seed, -1, -1e-37, true) + near(-87.3f, 100) +
                          near(-0.34657359f, 100) +
                          only({0, -0.0f, -1e-45f, -100, -1e10f, -kFloatMax, -std::numeric_limits<float>::infinity()});
        expect_within(run_kernel(device, "exp_negative", in), exp_oracle, Bound::relative(3 * kU));
    }
}

TEST_F(Kernel, PowerOneMinus) {
    for (unsigned seed : seeds()) {
        const Inputs random = generate(kMillion, 2, seed, [](Random& source, std::span<float> in) {
            in[0] = static_cast<float>(log_uniform(source, 1e-9, 0.999999));
            const double x = uniform(source, 0, 88); // every size of result, whatever s
            in[1] = static_cast<float>(x / -std::log1p(-static_cast<double>(in[0])));
        });
        const Inputs in = random + log_grid(1e-9, 0.99999, 512) * log_grid(1, 1e5, 512) +
                          turns_of_s() * only({0, 1, 2, 128, 200, 1000, 100000, 1e20f}) + only({0, 1e-10f, 0.5f}) * only({0, kFloatMax});
        expect_within(run_kernel(device, "power_one_minus", in), kPower, kPowerBound);
    }
}

TEST_F(Kernel, PowersKeepNaN) {
    const Oracle nan = constant(static_cast<double>(kNaN));
    for (const char* kernel : {"log_one_minus", "exp_negative"})
        expect_within(run_kernel(device, kernel, only({kNaN})), nan, Bound::exact());
    const Inputs in = only({kNaN}) * only({0, 1, 1000, 1e30f}) + only({0.001f}) * only({kNaN});
    expect_within(run_kernel(device, "power_one_minus", in), nan, Bound::exact());
}

// pow() is what the bound was made against: if it passed, the bound would prove nothing.
TEST_F(Kernel, NaivePowerIsReported) {
    const Inputs in = log_grid(1e-6, 0.01, 1000) * log_grid(1, 1000, 100);
    const Verdict verdict = judge(run_kernel(device, "naive_power", in), kPower, kPowerBound);
    EXPECT_FALSE(verdict.holds);
    EXPECT_NE(verdict.message.find("outside the bound; worst at (0x1."), std::string::npos) << verdict.message;
}

} // namespace lightbench::kernels
