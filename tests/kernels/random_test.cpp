// Random numbers from keys: uniform, and independent between keys that follow each other.
#include "kernel_test.h"

#include <cmath>
#include <numbers>

namespace lightbench::kernels {

namespace {

// Keys that grow by one along an axis from a start; the other three are the start's.
Inputs row_of_keys(std::size_t axis, std::size_t count, unsigned start) {
    Inputs keys{4, {}};
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 4; ++k) keys.values.push_back(static_cast<float>((k == axis ? i : 0) + (k + 1) * start));
    return keys;
}

// chi^2 of counts that should all be equal, as a normal deviate. Wilson, Hilferty 1931, "The distribution of chi-square".
double deviate(const std::vector<double>& counts) {
    double total = 0, chi2 = 0;
    for (double c : counts) total += c;
    const double bins = static_cast<double>(counts.size()), expected = total / bins, freedom = bins - 1;
    for (double c : counts) chi2 += (c - expected) * (c - expected) / expected;
    return (std::cbrt(chi2 / freedom) - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
}

// chi^2 over the squares of pairs (the a-th number of a key, the b-th of the key `step` further): uniform each and independent.
double pair_deviate(const KernelRun& run, std::size_t a, std::size_t b, std::size_t step) {
    constexpr std::size_t kBins = 32;
    std::vector<double> counts(kBins * kBins);
    for (std::size_t i = 0; i + step < run.inputs.count(); ++i) {
        const auto bin = [](float x) { return static_cast<std::size_t>(x * static_cast<float>(kBins)); };
        ++counts[bin(run.result(i)[a]) * kBins + bin(run.result(i + step)[b])];
    }
    return deviate(counts);
}

constexpr double kLimit =
    4.5; // 3.4e-6 one-sided; about 300 deviates are looked at, so chance alone fails one run in a thousand of new hashes

} // namespace

TEST_F(Kernel, RandomUnit4) {
    expect_rows(device, "random_unit4");
}

TEST_F(Kernel, RandomIsInRange) {
    const KernelRun run = run_kernel(device, "random_unit4", row_of_keys(0, kMillion, 1), 4);
    const auto worst = [](std::span<const float>, std::span<const float> out) {
        double outside = 0;
        for (float x : out) outside += x >= 0 && x < 1 && x * 0x1p24f == std::floor(x * 0x1p24f) ? 0 : 1;
        return outside;
    };
    expect_within(run, constant(0), Bound::exact(), worst);
}

// Along each part of the key: every one of the four numbers over fine bins, and its mean and variance.
TEST_F(Kernel, RandomIsUniform) {
    for (std::size_t axis = 0; axis < 4; ++axis) {
        const KernelRun run = run_kernel(device, "random_unit4", row_of_keys(axis, kMillion, 3), 4);
        for (std::size_t k = 0; k < 4; ++k) {
            std::vector<double> counts(4096);
            double sum = 0, squares = 0;
            for (std::size_t i = 0; i < run.inputs.count(); ++i) {
                const double x = static_cast<double>(run.result(i)[k]);
                ++counts[static_cast<std::size_t>(x * 4096)];
                sum += x;
                squares += (x - 0.5) * (x - 0.5);
            }
            const double n = static_cast<double>(run.inputs.count());
            EXPECT_LT(std::abs(deviate(counts)), kLimit) << axis << k;
            EXPECT_LT(std::abs(sum / n - 0.5) * std::sqrt(12 * n), kLimit) << axis << k;
            EXPECT_LT(std::abs(squares / n - 1.0 / 12) * std::sqrt(180 * n), kLimit) << axis << k;
        }
    }
}

TEST_F(Kernel, RandomIsIndependent) {
    for (std::size_t axis = 0; axis < 4; ++axis) {
        const KernelRun run = run_kernel(device, "random_unit4", row_of_keys(axis, kMillion, 5), 4);
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b)
                for (std::size_t step : {0u, 1u}) // of the same key, where they are not the same number; of the next one
                    if (step == 1 || a < b) {
                        EXPECT_LT(std::abs(pair_deviate(run, a, b, step)), kLimit) << axis << a << b << step;
                    }
    }
}

// The key decides alone: the same numbers whatever stands beside it, other numbers for the same parts in another order.
TEST_F(Kernel, RandomDependsOnTheKey) {
    const Inputs keys = row_of_keys(2, 1000, 7);
    const KernelRun together = run_kernel(device, "random_unit4", keys, 4);
    Inputs backwards{4, {}};
    for (std::size_t i = keys.count(); i-- > 0;) backwards.values.insert(backwards.values.end(), keys[i].begin(), keys[i].end());
    const KernelRun apart = run_kernel(device, "random_unit4", backwards, 4);
    for (std::size_t i = 0; i < keys.count(); ++i)
        for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(together.result(i)[k], apart.result(keys.count() - 1 - i)[k]);
    const KernelRun turned = run_kernel(device, "random_unit4", only({1, 2}) * only({1, 2}) * only({1, 2}) * only({1, 2}), 4);
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(turned.result(i)[0], turned.result(k)[0]);
}

} // namespace lightbench::kernels
