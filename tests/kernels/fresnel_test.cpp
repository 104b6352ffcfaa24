// Fresnel's reflectance against his sines and tangents in extended precision and 60 digits: CT-1, CT-2, CT-3.
#include "kernel_test.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

double excess(double c, double n) {
    return n * n + c * c - 1;
}

} // namespace

TEST_F(Kernel, FresnelDense) {
    expect_rows(device, "fresnel_dense");
}

TEST_F(Kernel, Fresnel) {
    expect_rows(device, "fresnel");
}

// 60 digits for 10^5 inputs, as the oracle in extended precision is only sampled by them otherwise.
TEST_F(Kernel, FresnelIn60Digits) {
    if (seeds().size() == 1) GTEST_SKIP() << "minutes: LIGHTBENCH_LONG_TESTS=1";
    const Claim any = row_of("fresnel").claims[0];
    const Oracle slow{any.oracle.in_60_digits, any.oracle.in_60_digits};
    const Inputs in = generate(100'000, 2, 7, [](Random& random, std::span<float> x) {
        x[0] = static_cast<float>(uniform(random, 0, 1));
        x[1] = static_cast<float>(log_uniform(random, 0.01, 100));
    });
    expect_within(run_kernel(device, "fresnel", in), slow, any.allowed);
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
    const Verdict verdict =
        judge(run_kernel(device, "naive_fresnel", grid(0.1, 1, 100) * log_grid(1.0003, 2, 100)), row_of("fresnel_dense").claims[0]);
    EXPECT_FALSE(verdict.holds);
    EXPECT_NE(verdict.message.find("outside the bound"), std::string::npos) << verdict.message;
}

TEST_F(Kernel, FresnelKeepsNaN) {
    const Inputs in = only({kNaN}) * only({0.5f, 1.5f, 100}) + only({0, 0.5f, 1}) * only({kNaN});
    for (const char* kernel : {"fresnel", "fresnel_dense"})
        expect_within(run_kernel(device, kernel, in), constant(static_cast<double>(kNaN)), Bound::exact());
}

} // namespace lightbench::kernels
