// Logarithms, exponentials and powers near 1 (lib/power.glsl) against double and 60 digits: LI-1's stable form.
#include "measure/numerics/rows.h"

#include <algorithm>
#include <cmath>

namespace lightbench::kernels {

namespace {

constexpr double kLeastExponent = static_cast<double>(-87.3f); // below, exp_negative is 0

Inputs axis(std::size_t count, unsigned seed, double low, double high, bool logarithmic) {
    return generate(count, 1, seed, [=](Random& random, std::span<float> x) {
        x[0] = static_cast<float>(logarithmic ? log_uniform(random, low, high) : uniform(random, low, high));
    });
}

// Where the exponent of 1 - s changes, and where 1 - s loses or keeps its digits.
Inputs turns_of_s() {
    return near(0.29289323f, 100) + near(0.5f, 100) + near(0.64644661f, 100) + near(0.01f, 100) + near(1e-7f, 100) +
           near(5.9604645e-8f, 100) + only({0, 1e-45f, 1e-38f, 0x1.fffffep-1f, 0x1.fffffcp-1f});
}

// (s, n) -> (1 - s)^n; 0 where it is no normal number.
const auto kPower = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    using std::log1p;
    const T x = in[1] * log1p(-in[0]);
    return x < kLeastExponent ? T(0) : T(exp(x));
};

// 2.5|x| from s = 0.01 on; about the exponent where results end, either side is right.
double power_bound(std::span<const float> in, double expected) {
    const double x = static_cast<double>(in[1]) * std::log1p(-static_cast<double>(in[0]));
    const double about_the_end = std::abs(x - kLeastExponent) < 1e-4 ? 1.3e-38 : 0;
    return (8 + (in[0] < 0.01f ? 2 : 2.5) * std::abs(x)) * kU * expected + about_the_end;
}

double log_bound(std::span<const float> in, double expected) {
    const double flushed = in[0] < 0x1p-126f ? 0x1p-126 : 0; // denormal s counts as 0 on some devices
    return (in[0] < 0.01f ? 1.1 : 2.5) * kU * std::abs(expected) + flushed;
}

Inputs power_inputs(std::size_t count, unsigned seed) {
    const Inputs random = generate(count, 2, seed, [](Random& source, std::span<float> in) {
        in[0] = static_cast<float>(log_uniform(source, 1e-9, 0.999999));
        const double x = uniform(source, 0, 88); // every size of result, whatever s
        in[1] = static_cast<float>(x / -std::log1p(-static_cast<double>(in[0])));
    });
    return random + log_grid(1e-9, 0.99999, 512) * log_grid(1, 1e5, std::max<std::size_t>(2, count / 2048)) +
           turns_of_s() * only({0, 1, 2, 128, 200, 1000, 100000, 1e20f}) + only({0, 1e-10f, 0.5f}) * only({0, kFloatMax});
}

Row log_one_minus_row() {
    const Oracle log_oracle = oracle([](auto in) {
        using std::log1p;
        return log1p(-in[0]);
    });
    return {"log_one_minus",
            "lib/power.glsl",
            "s in [0, 1)",
            "log_one_minus",
            1,
            [](std::size_t count, unsigned seed) {
                return axis(count / 2, seed, 0, 0.99999994, false) + axis(count / 2, seed, 1e-37, 0.99999994, true) + turns_of_s();
            },
            {{"", "relative 1.1 u for s < 0.01, 2.5 u above", log_oracle, Bound::function(log_bound)}}};
}

Row log_unit_row() {
    return {"log_unit",
            "lib/power.glsl",
            "x in [2^-126, 1]",
            "log_unit",
            1,
            [](std::size_t count, unsigned seed) {
                return axis(count / 2, seed, 0x1p-20, 1, false) + axis(count / 2, seed, 0x1p-126, 1, true) + near(0.70710678f, 100) +
                       near(0.35355339f, 100) + only({1, 0x1p-126f, 0x1.fffffep-1f});
            },
            {{"", "relative 2.5 u", oracle([](auto x) { return log(x[0]); }), Bound::relative(2.5 * kU)}}};
}

Row exp_negative_row() {
    const Oracle exp_oracle = oracle([](auto in) {
        using T = std::remove_cvref_t<decltype(in[0])>;
        return in[0] < kLeastExponent ? T(0) : T(exp(in[0]));
    });
    return {"exp_negative",
            "lib/power.glsl",
            "x <= 0, -inf too",
            "exp_negative",
            1,
            [](std::size_t count, unsigned seed) {
                return axis(count / 2, seed, -90, 0, false) + axis(count / 2, seed, -1, -1e-37, true) + near(-87.3f, 100) +
                       near(-0.34657359f, 100) +
                       only({0, -0.0f, -1e-45f, -100, -1e10f, -kFloatMax, -std::numeric_limits<float>::infinity()});
            },
            {{"", "relative 3 u", exp_oracle, Bound::relative(3 * kU)}}};
}

} // namespace

Rows power_rows() {
    return {log_one_minus_row(),
            log_unit_row(),
            exp_negative_row(),
            {"power_one_minus",
             "lib/phong.glsl",
             "s in [0, 1), n >= 0",
             "power_one_minus",
             1,
             power_inputs,
             {{"", "relative (8 + 2|x|) u, x = n ln(1 - s); 2.5|x| from s = 0.01 on", oracle(kPower), Bound::function(power_bound)}}}};
}

} // namespace lightbench::kernels
