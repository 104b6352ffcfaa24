// The filtered checkerboard against sums over the pieces of the square wave, in double.
#include "kernel_test.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

double wave(double x) {
    return x - std::floor(x) < 0.5 ? 1 : -1;
}

// Mean over [x - w/2, x + w/2]: whole periods add nothing, what is left is cut at the multiples of 1/2.
double mean(double x, double w) {
    if (std::abs(2 * x - std::round(2 * x)) >= w) return wave(x); // no edge inside; sums would lose the digits of a small w
    const double from = x - std::floor(x) - std::fmod(w / 2, 1.0), to = from + std::fmod(w, 1.0); // shifted by whole periods
    double sum = 0;
    for (double at = from; at < to;) {
        const double next = std::min(to, std::floor(2 * at + 1) / 2);
        sum += (next - at) * wave((at + next) / 2);
        at = next;
    }
    return sum / w;
}

double checker(std::span<const float> in) {
    const auto width = [&](std::size_t i) { return std::abs(static_cast<double>(in[i])) + std::abs(static_cast<double>(in[i + 2])); };
    return 0.5 - 0.5 * mean(static_cast<double>(in[0]), width(2)) * mean(static_cast<double>(in[1]), width(3));
}

const Oracle kChecker{checker, checker};

} // namespace

TEST_F(Kernel, Checker) {
    for (unsigned seed : seeds()) {
        const Inputs in = generate(kMillion, 6, seed, [](Random& random, std::span<float> values) {
            const double range = log_uniform(random, 0.1, 1e6), width = log_uniform(random, 1e-9, 1e5);
            for (std::size_t i = 0; i < 6; ++i) values[i] = static_cast<float>(uniform(random, -1, 1) * (i < 2 ? range : width));
        });
        expect_within(run_kernel(device, "checker", in), kChecker, Bound::absolute(8 * kU));
    }
}

TEST_F(Kernel, CheckerUnfiltered) {
    const Inputs axis = grid(-3, 3, 601) + near(0.5f, 3) + near(0, 1) + near(1, 3) + only({1e9f, -1e9f, 3e38f});
    std::vector<float> values;
    for (float x : axis.values)
        if (!(x < 0 && x > -1e-7f)) values.push_back(x); // whose fraction is 1 in float: either side is right
    const Inputs places{1, values};
    expect_within(run_kernel(device, "checker", places * places * only({0}) * only({0.0f}) * only({0}) * only({-0.0f})), kChecker,
                  Bound::exact());
}

// Huge and broken footprints are grey: a finite number, whatever comes.
TEST_F(Kernel, CheckerOfHugeFootprints) {
    const Inputs axis = only({0, 0.3f, -7.7f, 1e9f}), wide = only({1e7f, 1e30f, kFloatMax, std::numeric_limits<float>::infinity(), kNaN});
    expect_within(run_kernel(device, "checker", axis * axis * wide * wide * wide * wide), constant(0.5), Bound::absolute(1e-12));
}

} // namespace lightbench::kernels
