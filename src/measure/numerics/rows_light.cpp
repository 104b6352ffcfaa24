// The laws of attenuation and the edge of spots against their formulas: AT-1, AT-2.
#include "measure/numerics/rows.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace lightbench::kernels {

namespace {

const auto kInverseSquare = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    return 1 / (4 * boost::math::constants::pi<T>() * in[0] * in[0]);
};

// (cos_angle, cos_outer, cos_inner)
const auto kFalloff = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    if (in[0] >= in[2]) return T(1);
    if (in[0] <= in[1]) return T(0);
    const T t = (in[0] - in[1]) / (in[2] - in[1]);
    return T(t * t * (3 - 2 * t));
};

Inputs sums_of_distances(std::size_t count, unsigned) {
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
    return (only({0}) + log_grid(1e-18, 1e18, side - 1)) * log_grid(1e-18, 1e18, side) + only({1e-18f, 1, 1e18f}) * only({0}) +
           near(1, 1000) * near(1, 10);
}

Inputs distances(std::size_t count, unsigned seed) {
    return log_grid(1e-15, 1e15, count / 2) + generate(count, 1, seed, [](Random& random, std::span<float> d) {
               d[0] = static_cast<float>(log_uniform(random, 1e-15, 1e15));
           });
}

// Cones of any width, angles about and inside their edges; edges of a few ulp.
Inputs cones(std::size_t count, unsigned seed) {
    return generate(count, 3, seed,
                    [](Random& random, std::span<float> in) {
                        in[1] = static_cast<float>(uniform(random, -1, 1));
                        in[2] = static_cast<float>(uniform(random, static_cast<double>(in[1]), 1));
                        const double width = static_cast<double>(in[2]) - static_cast<double>(in[1]);
                        in[0] = static_cast<float>(static_cast<double>(in[1]) + uniform(random, -0.2, 1.2) * width);
                    }) +
           near(0.999f, 50) * only({0.999f}) * near(0.99901f, 50);
}

} // namespace

Rows light_rows() {
    return {{"attenuation_linear",
             "lib/attenuation.glsl",
             "d + d0 in [1e-18, 1e18]",
             "attenuation_linear",
             1,
             sums_of_distances,
             {{"", "relative 4 u", oracle([](auto in) { return 1 / (in[0] + in[1]); }), Bound::relative(4 * kU)}}},
            {"attenuation_inverse_square",
             "lib/attenuation.glsl",
             "d in [1e-15, 1e15]",
             "attenuation_inverse_square",
             1,
             distances,
             {{"", "relative 4 u", oracle(kInverseSquare), Bound::relative(4 * kU)}}},
            {"spot_falloff",
             "lib/spot.glsl",
             "cosines in [-1, 1], edges of a few ulp too",
             "spot_falloff",
             1,
             cones,
             {{"", "absolute 8 u", oracle(kFalloff), Bound::absolute(8 * kU)}}}};
}

} // namespace lightbench::kernels
