// Mirrored and refracted directions against Snell's law in double: RF-1, RF-3.
#include "measure/numerics/lines.h"
#include "measure/numerics/rows.h"

#include <numbers>

namespace lightbench::kernels {

namespace {

double off_unit(std::span<const float>, std::span<const float> out) {
    return length(vec_of(out, 0)) - 1;
}

double off_mirrored(std::span<const float> in, std::span<const float> out) {
    const Vec3 i = vec_of(in, 0), n = unit(vec_of(in, 3));
    return length(vec_of(out, 0) - (i + (-2 * dot(i, n)) * n));
}

Inputs mirrors(std::size_t count, unsigned seed) {
    return generate(count, 6, seed, [](Random& random, std::span<float> in) {
        put(in, 0, random_direction(random));
        put(in, 3, random_at(random, 1e-15, 1e15));
    });
}

// From normal incidence to grazing, into dense and thin media and into all but the same one; inside the critical angle.
Inputs panes(std::size_t count, unsigned seed) {
    return generate(count, 7, seed, [](Random& random, std::span<float> in) {
        const bool thin = uniform(random, 0, 1) < 0.3;
        const double eta = thin ? uniform(random, 0.3, 1) : 1 + log_uniform(random, 1e-6, 10);
        const double most = thin ? 0.999 * std::asin(eta) : 0.4999 * std::numbers::pi;
        fill_incidence(random, in, uniform(random, 0, 1) < 0.3 ? log_uniform(random, 1e-8, most) : uniform(random, 0, most));
        in[6] = static_cast<float>(eta);
    });
}

// The refracted direction by angles: sin(b) = sin(a) / eta, b from -n towards the side where i goes; nothing beyond the critical angle.
// sin(a) is the length of what i is off n, both made unit again.
Vec3 snell(std::span<const float> in) {
    const Vec3 i = unit(vec_of(in, 0)), n = unit(vec_of(in, 3));
    const Vec3 along = i - dot(i, n) * n;
    const double sine = length(along), b = std::asin(sine / static_cast<double>(in[6]));
    return (sine > 0 ? std::sin(b) / sine : 0) * along - std::cos(b) * n;
}

double off_snell(std::span<const float> in, std::span<const float> out) {
    return length(vec_of(out, 0) - snell(in));
}

double snell_bound(std::span<const float> in, double) {
    const Vec3 i = unit(vec_of(in, 0)), n = unit(vec_of(in, 3));
    const double eta = static_cast<double>(in[6]), sine = length(i - dot(i, n) * n) / eta, thin = std::max(1.0, 1 / eta);
    return (thin > 1 ? 8 : 4) * kU * thin / std::sqrt((1 - sine) * (1 + sine));
}

} // namespace

Rows refraction_rows() {
    return {{"mirror_direction",
             "lib/refraction.glsl",
             "i unit, |n| in [1e-15, 1e15]",
             "mirror_direction",
             3,
             mirrors,
             {{"length", "absolute 4 u", constant(0), Bound::absolute(4 * kU), off_unit},
              {"direction", "absolute 8 u", constant(0), Bound::absolute(8 * kU), off_mirrored}}},
            {"refracted_direction",
             "lib/refraction.glsl",
             "i, n unit, eta in [0.3, 11], to the critical angle",
             "refracted_direction",
             4,
             panes,
             {{"length", "absolute 4 u", constant(0), Bound::absolute(4 * kU), off_unit},
              {"direction", "absolute 4 u / cos(b); eta < 1: 8 u / (eta cos(b))", constant(0), Bound::function(snell_bound), off_snell},
              {"passes", "exact", constant(1), Bound::exact(), component(3)}}}};
}

} // namespace lightbench::kernels
