// Lengths and directions against hypotenuses in double and 60 digits: LI-4.
#include "measure/numerics/rows.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

// Directions all over the sphere, lengths from low to high evenly in the logarithm.
Inputs vectors(std::size_t count, double low, double high, unsigned seed) {
    return generate(count, 3, seed, [=](Random& random, std::span<float> v) {
        double d[3];
        unit_vector(random, d);
        const double length = log_uniform(random, low, high);
        for (int i = 0; i < 3; ++i) v[i] = static_cast<float>(d[i] * length);
    });
}

// Components of very different size, and few at a time.
Inputs lopsided(const Inputs& axis) {
    return axis * axis * axis;
}

double length_of(std::span<const float> v) {
    return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
}

// Devices may flush denormal numbers: two components below this count as zero then, in length (squared) and in direction.
constexpr double kLeastNormal = 0x1p-126;

double length_bound(std::span<const float>, double expected) {
    return 3 * kU * expected + (expected > 0 ? kLeastNormal * kLeastNormal / expected : 0);
}
double direction_bound(std::span<const float> in, double) {
    return 3 * kU + 1.5 * kLeastNormal / length_of(in.first(3));
}

double result_length(std::span<const float>, std::span<const float> out) {
    return length_of(out);
}

// Distance of the result from the direction of the first three arguments.
double off_direction(std::span<const float> in, std::span<const float> out) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double miss = static_cast<double>(out[i]) - static_cast<double>(in[i]) / length_of(in.first(3));
        sum += miss * miss;
    }
    return std::sqrt(sum);
}

Inputs lengths(std::size_t count, unsigned seed) {
    return vectors(count, 1e-37, 3e38, seed) +
           lopsided(only({0, 1e-37f, -3e-20f, 1, -1e18f, 2e19f, 1.7e38f})) + // squares of 2e19 overflow, of 1e-37 vanish
           lopsided(only({3.0f, -4.0f, 12.0f, 84.0f}));
}

Inputs directions(std::size_t count, unsigned seed) {
    return (vectors(count, 1e-37, 3e38, seed) + lopsided(only({1e-37f, -3e-20f, 1, -1e18f, 2e19f, 1.7e38f})) +
            lopsided(near(1, 20) + near(0.5, 20))) * // squares that add up to all but a power of two
           (only({0}) * only({0}) * only({1}));
}

} // namespace

Rows vector_rows() {
    const Oracle length = oracle([](auto v) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); });
    return {{"safe_length",
             "lib/vector.glsl",
             "length in [1e-37, 3e38]",
             "safe_length",
             1,
             lengths,
             {{"", "relative 3 u", length, Bound::function(length_bound)}}},
            {"safe_normalize",
             "lib/vector.glsl",
             "length in [1e-37, 3e38]",
             "safe_normalize",
             3,
             directions,
             {{"length", "absolute 2 u", constant(1), Bound::absolute(2 * kU), result_length},
              {"direction", "absolute 3 u", constant(0), Bound::function(direction_bound), off_direction}}},
            {"fast_normalize",
             "lib/vector.glsl",
             "length in [1e-15, 1e18]",
             "fast_normalize",
             3,
             [](std::size_t count, unsigned seed) { return vectors(count, 1e-15, 1e18, seed) + vectors(count, 0.5, 2, seed + 100); },
             {{"length", "absolute 6 u", constant(1), Bound::absolute(6 * kU), result_length},
              {"direction", "absolute 7 u", constant(0), Bound::absolute(7 * kU), off_direction}}}};
}

} // namespace lightbench::kernels
