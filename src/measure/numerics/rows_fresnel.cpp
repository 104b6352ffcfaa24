// Fresnel's reflectance against his sines and tangents in extended precision and 60 digits: CT-1, CT-2.
#include "measure/numerics/rows.h"

#include <algorithm>
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

double any_bound(std::span<const float> in, double expected) {
    const double c = static_cast<double>(in[0]), n = static_cast<double>(in[1]);
    return n < 1 && excess(c, n) < 0.1 * c * c ? 1.5e-6 : 3.2e-6 * expected;
}

double dense_bound(std::span<const float> in, double expected) {
    const double c = static_cast<double>(in[0]), n = static_cast<double>(in[1]), k = excess(c, n);
    if (n >= 1) return 3.2e-6 * expected;
    return k > 0.1 ? 2.9e-6 : 1e-3 / (n * n);
}

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

Inputs random_angles(std::size_t count, unsigned seed, double low, double high) {
    return generate(count, 2, seed, [=](Random& random, std::span<float> in) {
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

Inputs into_dense(std::size_t count, unsigned seed) {
    return cosines() * indices(true) + random_angles(count, seed, 1.00002, 900);
}
Inputs into_any(std::size_t count, unsigned seed) {
    return cosines() * indices(false) + about_critical(200, 4) + random_angles(count, seed, 0.02, 0.99998);
}
Inputs into_thin(std::size_t count, unsigned seed) {
    return random_angles(count, seed, 0.4, 0.99998);
}

} // namespace

Rows fresnel_rows() {
    const Oracle fresnel{in_extended, in_60_digits};
    const Claim any{"", "relative 3.2e-6; n < 1, k < 0.1 c^2: absolute 1.5e-6", fresnel, Bound::function(any_bound)};
    const Claim dense{"", "relative 3.2e-6", fresnel, Bound::function(dense_bound)};
    const Claim thin{"", "absolute 2.9e-6 for k > 0.1, else 1e-3/n^2", fresnel, Bound::function(dense_bound)};
    const std::string file = "lib/fresnel.glsl";
    return {{"fresnel_dense", file, "c in [0, 1], n in [1, 1e9]", "fresnel_dense", 1, into_dense, {dense}},
            {"fresnel_dense", file, "c in [0, 1], n in [0.4, 1)", "fresnel_dense", 1, into_thin, {thin}},
            {"fresnel", file, "c in [0, 1], n in [1, 1e9]", "fresnel", 1, into_dense, {any}},
            {"fresnel", file, "c in [0, 1], n in [1e-9, 1), the critical angle", "fresnel", 1, into_any, {any}}};
}

} // namespace lightbench::kernels
