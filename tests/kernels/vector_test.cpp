// Lengths and directions against hypotenuses in double and 60 digits: LI-4, NI-1.
#include "kernel_test.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

// Directions all over the sphere, lengths from low to high evenly in the logarithm.
void fill_vector(Random& random, std::span<float> v, double low, double high) {
    double d[3];
    unit_vector(random, d);
    const double length = log_uniform(random, low, high);
    for (int i = 0; i < 3; ++i) v[i] = static_cast<float>(d[i] * length);
}

// Components of very different size, and few at a time.
Inputs lopsided(const Inputs& axis) {
    return axis * axis * axis;
}

double length_of(std::span<const float> v) {
    return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
}

double result_length(std::span<const float>, std::span<const float> out) {
    return length_of(out);
}

// Distance of the result from arguments [first, first + 3).
Measure off_argument(std::size_t first) {
    return [=](std::span<const float> in, std::span<const float> out) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += std::abs(static_cast<double>(out[i]) - static_cast<double>(in[first + i]));
        return sum;
    };
}

} // namespace

TEST_F(Kernel, SafeLength) {
    expect_rows(device, "safe_length");
}

TEST_F(Kernel, SafeLengthOfWhatHasNone) {
    const Inputs in = only({kNaN, 1}) * only({kNaN, 3e38f}) * only({kNaN});
    expect_within(run_kernel(device, "safe_length", in), constant(static_cast<double>(kNaN)), Bound::exact());
    expect_within(run_kernel(device, "safe_length", lopsided(only({0.0f, -0.0f}))), constant(0), Bound::exact());
}

TEST_F(Kernel, SafeNormalize) {
    expect_rows(device, "safe_normalize");
}

TEST_F(Kernel, SafeNormalizeOfAnything) {
    const Inputs fallback = only({0.6f}) * only({0}) * only({0.8f});
    const Inputs in = (random_bits(kMillion, 3, 1) + lopsided(special_values())) * fallback;
    expect_within(run_kernel(device, "safe_normalize", in, 3), constant(1), Bound::absolute(2 * kU), result_length);
}

TEST_F(Kernel, SafeNormalizeFallsBack) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const Inputs none = lopsided(only({0.0f, -0.0f, 1e-40f}));
    const Inputs bad = only({kNaN, kInfinity, -kInfinity});
    const Inputs any = only({0, 1, -3e38f}) + bad;
    const Inputs in = none + bad * any * any + any * bad * any + any * any * bad;
    const Inputs fallback = only({0.25f}) * only({-0.5f}) * only({7});
    expect_within(run_kernel(device, "safe_normalize", in * fallback, 3), constant(0), Bound::exact(), off_argument(3));
}

TEST_F(Kernel, FastNormalize) {
    expect_rows(device, "fast_normalize");
}

// NI-1: between a normal and its opposite there is a point without any; near it the direction is the rounding's, but a direction it is.
TEST_F(Kernel, InterpolatedNormal) {
    const auto opposite = [](Random& random, std::span<float> in) {
        fill_vector(random, in.subspan(0, 3), 1, 1);
        for (int i = 0; i < 3; ++i) in[3 + i] = -in[i];
        fill_vector(random, in.subspan(6, 3), 1, 1);
    };
    const Inputs normals = generate(1u << 15, 9, 1, opposite);
    const KernelRun middle = run_kernel(device, "interpolated_normal", normals * only({0.5f}), 3);
    expect_within(middle, constant(0), Bound::exact(), off_argument(6));
    const KernelRun beside = run_kernel(device, "interpolated_normal", normals * (near(0.5f, 8) + grid(0, 1, 17)), 3);
    expect_within(beside, constant(1), Bound::absolute(4 * kU), result_length); // the fallback itself is unit to 2 u only
}

} // namespace lightbench::kernels
