// The origin of a ray that leaves a surface: beyond the error of its point, and not much further: SP-4, SH-1.
#include "measure/numerics/rays.h"
#include "measure/numerics/rows.h"

namespace lightbench::kernels {

namespace {

// (p, error, n, d)
Inputs surface_points(std::size_t count, unsigned seed) {
    return generate(count, 12, seed, [](Random& random, std::span<float> in) {
        const Vec3 p = log_uniform(random, 1e-6, 1e6) * random_direction(random), n = random_direction(random);
        put(in, 0, p);
        put(in, 6, n);
        for (std::size_t k = 0; k < 3; ++k) {
            in[3 + k] = static_cast<float>(log_uniform(random, 0.5, 1e3) * kU * std::abs(k == 0 ? p.x : k == 1 ? p.y : p.z));
            if (random() % 16 == 0) in[k] = random() % 2 ? 0 : -0.0f;
            if (random() % 16 == 0) in[6 + k] = 0;
        }
        put(in, 6, unit(vec_of(in, 6)));
        put(in, 9, random_direction(random));
    });
}

double error_along_normal(std::span<const float> in) {
    const Vec3 n = vec_of(in, 6), e = vec_of(in, 3);
    return std::abs(n.x) * e.x + std::abs(n.y) * e.y + std::abs(n.z) * e.z;
}

// How far the origin has moved to the side of d, as a share of the error: at least 1 less roundings of n * away.
double moved(std::span<const float> in, std::span<const float> out) {
    const Vec3 n = vec_of(in, 6), d = vec_of(in, 9);
    const double side = dot(d, n);
    if (std::abs(side) < 4 * kU) return 1;
    return (side < 0 ? -1 : 1) * dot(vec_of(out, 0) - vec_of(in, 0), n) / error_along_normal(in);
}

// How much farther than its error: n * error, the rounding of the sum and one float for every coordinate.
double too_far(std::span<const float> in, std::span<const float> out) {
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const float q = std::abs(out[k]);
        const double ulp = static_cast<double>(std::nextafter(q, kFloatMax) - q) + 0x1p-126;
        const double step = std::abs(static_cast<double>(in[6 + k])) * error_along_normal(in);
        worst = std::max(worst, over(std::abs(static_cast<double>(out[k]) - static_cast<double>(in[k])), step * (1 + 8 * kU) + 2 * ulp));
    }
    return worst;
}

double not_moved(std::span<const float> in, std::span<const float> out) {
    return std::max(0.0, 1 - 8 * kU - moved(in, out));
}

} // namespace

Rows offset_rows() {
    return {{"offset_origin",
             "lib/ray.glsl",
             "|p| in [1e-6, 1e6], error of 0.5 to 1e3 u",
             "offset_origin",
             3,
             surface_points,
             {{"beyond the error", "by the whole of it", constant(0), Bound::exact(), not_moved},
              {"not further", "a float more, and rounding", constant(0), Bound::absolute(1), too_far}}}};
}

} // namespace lightbench::kernels
