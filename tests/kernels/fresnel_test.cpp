// Fresnel's reflectance against his sines and tangents in extended precision and 60 digits: CT-1, CT-2, CT-3.
#include "kernel_test.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

// SPEC S6 from the cosine of incidence and the index: phi and theta the angles of incidence and of refraction.
template <class T> T fresnel_formula(T cosine, T n) {
    using std::asin, std::sin, std::sqrt, std::tan;
    if (n == 1) return 0;
    const T phi = 2 * asin(sqrt((1 - cosine) / 2)), sine = sin(phi) / n; // acos() would lose the digits of 1 - cosine
    if (phi == 0) return (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    if (n < 1 && n * n + cosine * cosine - 1 <= 0) return 1;
    const T theta = asin(sine < 1 ? sine : T(1));
    const T s = sin(phi - theta) / sin(phi + theta), p = tan(phi - theta) / tan(phi + theta);
    return (s * s + p * p) / 2;
}

double excess(double c, double n) {
    return n * n + c * c - 1;
}

double in_60_digits(std::span<const float> in) {
    return static_cast<double>(fresnel_formula(Precise(in[0]), Precise(in[1])));
}

// 64 bits where the angles do not cancel and the arcsine is not at its end.
double in_extended(std::span<const float> in) {
    const double c = static_cast<double>(in[0]), n = static_cast<double>(in[1]);
    const bool hard = std::abs(n - 1) < 1e-5 || (n < 1 && std::abs(excess(c, n)) < 1e-7) || n > 1e3 || c < 1e-3;
    return hard ? in_60_digits(in) : static_cast<double>(fresnel_formula<long double>(in[0], in[1]));
}

const Oracle kFresnel{in_extended, in_60_digits};

// As fresnel.glsl states it.
const Bound kFresnelBound = Bound::function([](std::span<const float> in, double expected) {
    const double c = static_cast<double>(in[0]), n = static_cast<double>(in[1]);
    return n < 1 && excess(c, n) < 0.1 * c * c ? 1.5e-6 : 3.2e-6 * expected;
});

const Bound kDenseBound = Bound::function([](std::span<const float> in, double expected) {
    const double c = static_cast<double>(in[0]), n = static_cast<double>(in[1]), k = excess(c, n);
    if (n >= 1) return 3.2e-6 * expected;
    return k > 0.1 ? 2.9e-6 : 1e-3 / (n * n);
});

// The cosine of the critical angle of n < 1 and its neighbours; n on a grid.
Inputs about_critical(std::size_t indices, int steps) {
    Inputs all{2, {}};
    for (float n : log_grid(1e-4, 0.9999999, indices).values) {
        const double c = std::sqrt((1 - static_cast<double>(n)) * (1 + static_cast<double>(n)));
        all = all + near(static_cast<float>(c), steps) * only({n});
    }
    for (std::size_t i = 0; i < all.values.size(); i += 2) all.values[i] = std::min(all.values[i], 1.0f);
    return all;
}

Inputs random_angles(unsigned seed, double low, double high) {
    return generate(kMillion, 2, seed, [=](Random& random, std::span<float> in) {
        in[0] = static_cast<float>(random() % 4 == 0 ? log_uniform(random, 1e-3, 1) : uniform(random, 1e-3, 1));
        in[1] = static_cast<float>(log_uniform(random, low, high));
    });
}

Inputs cosines() {
    Inputs all = only({0, 1e-45f, 1e-38f, 1e-30f, 1e-20f, 1e-10f, 1e-5f, 1e-3f}) + near(1, 4) + grid(0, 1, 65);
    std::erase_if(all.values, [](float c) { return c > 1; });
    return all;
}

// From 1e-9 to 1e9, and those next to 1, where equals are subtracted.
Inputs indices(bool dense) {
    Inputs all = near(1.0f, 16) + only({1.0003f, 1.33f, 1.5f, 2.4f, 10, 1000, 1e6f, 1e9f}) +
                 only({1e-9f, 1e-6f, 1e-3f, 0.1f, 0.5f, 0.667f, 0.75f, 0.99f, 0.999f});
    std::erase_if(all.values, [=](float n) { return dense && n < 1; });
    return all;
}

} // namespace

TEST_F(Kernel, FresnelDense) {
    const Inputs corners = cosines() * indices(true);
    expect_within(run_kernel(device, "fresnel_dense", corners), kFresnel, kDenseBound);
    expect_within(run_kernel(device, "fresnel", corners), kFresnel, kFresnelBound);
    for (unsigned seed : seeds()) {
        const Inputs in = random_angles(seed, 1.00002, 900);
        expect_within(run_kernel(device, "fresnel_dense", in), kFresnel, kDenseBound);
        expect_within(run_kernel(device, "fresnel", in), kFresnel, kFresnelBound);
    }
}

TEST_F(Kernel, Fresnel) {
    expect_within(run_kernel(device, "fresnel", cosines() * indices(false)), kFresnel, kFresnelBound);
    expect_within(run_kernel(device, "fresnel", about_critical(200, 4)), kFresnel, kFresnelBound);
    for (unsigned seed : seeds()) expect_within(run_kernel(device, "fresnel", random_angles(seed, 0.02, 0.99998)), kFresnel, kFresnelBound);
}

// Cook-Torrance of a surface that is thinner than its surroundings: usable, within what fresnel.glsl says.
TEST_F(Kernel, FresnelDenseOfThinMedia) {
    for (unsigned seed : seeds())
        expect_within(run_kernel(device, "fresnel_dense", random_angles(seed, 0.4, 0.99998)), kFresnel, kDenseBound);
}

// 60 digits for 10^5 inputs, as the oracle in extended precision is only sampled by them otherwise.
TEST_F(Kernel, FresnelIn60Digits) {
    if (seeds().size() == 1) GTEST_SKIP() << "minutes: LIGHTBENCH_LONG_TESTS=1";
    const Oracle slow{in_60_digits, in_60_digits};
    const Inputs in = generate(100'000, 2, 7, [](Random& random, std::span<float> x) {
        x[0] = static_cast<float>(uniform(random, 0, 1));
        x[1] = static_cast<float>(log_uniform(random, 0.01, 100));
    });
    expect_within(run_kernel(device, "fresnel", in), slow, kFresnelBound);
}

// CT-3. Numbers that need no computer.
TEST_F(Kernel, FresnelAnchors) {
    for (const char* kernel : {"fresnel", "fresnel_dense"}) {
        expect_within(run_kernel(device, kernel, only({1}) * only({1.5f})), constant(0.04), Bound::ulp(4));
        expect_within(run_kernel(device, kernel, only({0}) * log_grid(1.001, 1000, 100)), constant(1), Bound::ulp(4));
        expect_within(run_kernel(device, kernel, grid(0, 1, 100) * only({1})), constant(0), Bound::exact());
        // Brewster's angle, tan(phi) = n: only the amplitude s is left, 5/13 for n = 1.5.
        const float brewster = static_cast<float>(1 / std::sqrt(3.25));
        expect_within(run_kernel(device, kernel, only({brewster}) * only({1.5f})), constant(0.5 * 25 / 169), Bound::ulp(4));
        expect_within(run_kernel(device, kernel, only({0.5f, 0.7f}) * only({0.5f, 0.6f})), constant(1), Bound::exact());
    }
    // From within, at the critical angle and beyond by one step: total.
    expect_within(run_kernel(device, "fresnel", only({0.8f}) * only({0x1.333332p-1f})), constant(1), Bound::absolute(4e-3));
    expect_within(run_kernel(device, "fresnel", only({0}) * log_grid(1e-3, 0.999, 100)), constant(1), Bound::exact());
}

// CT-3. Light takes the same way back: F(phi, n) = F(theta, 1/n), n and 1/n both exact.
TEST_F(Kernel, FresnelIsReversible) {
    Inputs there{2, {}}, back{2, {}};
    for (float n : {2.0f, 4.0f, 8.0f})
        for (float c : grid(0.05, 1, 1000).values) {
            const double sine = std::sqrt((1 - static_cast<double>(c)) * (1 + static_cast<double>(c))) / static_cast<double>(n);
            there.values.insert(there.values.end(), {c, n});
            back.values.insert(back.values.end(), {static_cast<float>(std::sqrt((1 - sine) * (1 + sine))), 1 / n});
        }
    const KernelRun run = run_kernel(device, "fresnel", there), reversed = run_kernel(device, "fresnel", back);
    double worst = 0;
    for (std::size_t i = 0; i < there.count(); ++i) {
        // the way back starts from a rounded cosine, which is u/2 of it; F(theta) changes by as much as this times its slope
        const double theta = static_cast<double>(back[i][0]), n = static_cast<double>(back[i][1]), k = excess(theta, n);
        const double slope = 2 * (1 / theta + 1 / (n * n * theta)) * theta / std::sqrt(k);
        const double off = std::abs(static_cast<double>(run.results[i]) - static_cast<double>(reversed.results[i]));
        worst = std::max(worst, off / (5e-7 + slope * kU));
    }
    EXPECT_LE(worst, 1);
}

// Cook and Torrance's own g and c, which the bound was made against: if they passed, it would prove nothing.
TEST_F(Kernel, NaiveFresnelIsReported) {
    const Verdict verdict = judge(run_kernel(device, "naive_fresnel", grid(0.1, 1, 100) * log_grid(1.0003, 2, 100)), kFresnel, kDenseBound);
    EXPECT_FALSE(verdict.holds);
    EXPECT_NE(verdict.message.find("outside the bound"), std::string::npos) << verdict.message;
}

TEST_F(Kernel, FresnelKeepsNaN) {
    const Inputs in = only({kNaN}) * only({0.5f, 1.5f, 100}) + only({0, 0.5f, 1}) * only({kNaN});
    for (const char* kernel : {"fresnel", "fresnel_dense"})
        expect_within(run_kernel(device, kernel, in), constant(static_cast<double>(kNaN)), Bound::exact());
}

} // namespace lightbench::kernels
