// Gradient noise, waves and the checkerboard against their definitions in double and 60 digits.
#include "kernel_test.h"

#include <array>
#include <cmath>

namespace lightbench::kernels {

namespace {

// One corner's weight along an axis. t: from the cell's lower side.
double weight(double t, bool upper) {
    const double s = t * t * t * (t * (6 * t - 15) + 10);
    return upper ? s : 1 - s;
}

Inputs places(unsigned seed, double range) {
    return generate(kMillion / 2, 3, seed, [=](Random& random, std::span<float> q) {
        for (float& x : q) x = static_cast<float>(uniform(random, -range, range));
    });
}

} // namespace

TEST_F(Kernel, GradientNoise) {
    expect_rows(device, "gradient_noise");
}

// The largest value that any choice of gradients allows: at every place each corner's plane is at most the sum of its two larger distances.
TEST_F(Kernel, GradientNoiseIsInRange) {
    constexpr int kSteps = 100;
    double most = 0;
    for (int n = 0; n <= kSteps * kSteps * kSteps; ++n) {
        const std::array<double, 3> f{n % kSteps / 1.0 / kSteps, n / kSteps % kSteps / 1.0 / kSteps, n / kSteps / kSteps / 1.0 / kSteps};
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            double whole = 1, all = 0, least = 1;
            for (std::size_t i = 0; i < 3; ++i) {
                const int upper = corner >> i & 1;
                whole *= weight(f[i], upper != 0);
                all += std::abs(f[i] - upper);
                least = std::min(least, std::abs(f[i] - upper));
            }
            sum += whole * (all - least);
        }
        most = std::max(most, sum);
    }
    EXPECT_NEAR(most, 1.03623, 1e-4);
    EXPECT_LT(most * 0.96, 1);
    const Measure beyond = [](std::span<const float>, std::span<const float> out) {
        return std::max(0.0, std::abs(static_cast<double>(out[3])) - 1);
    };
    expect_within(run_kernel(device, "gradient_noise", places(7, 1000), 4), constant(0), Bound::exact(), beyond);
}

TEST_F(Kernel, SineCosine) {
    expect_rows(device, "sine_cosine");
}

TEST_F(Kernel, Waves) {
    expect_rows(device, "waves");
}

} // namespace lightbench::kernels
