// Lambert's and Phong's factors against their formulas in double and 60 digits: LI-1, LI-2, LI-3.
#include "measure/numerics/rows.h"

#include <algorithm>
#include <cmath>

namespace lightbench::kernels {

namespace {

template <class V> auto dot(const V& a, const V& b) {
    using T = std::remove_cvref_t<decltype(a[0])>;
    return T(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <class T> struct Reflection {
    T nl, cosine; // N.L; cosine of the angle between R and V
};

// (n, l, v, shininess): R = 2 (N.L) N - L of the vectors as given; the angle forgives that R and V are unit in float only.
template <class T> Reflection<T> reflect(std::span<const T> in) {
    const std::span<const T> n = in.subspan(0, 3), l = in.subspan(3, 3), v = in.subspan(6, 3);
    const T nl = dot(n, l);
    const T data[3] = {T(2 * nl * n[0] - l[0]), T(2 * nl * n[1] - l[1]), T(2 * nl * n[2] - l[2])};
    const std::span<const T> r(data);
    using std::sqrt;
    return {nl, T(dot(r, v) / sqrt(T(dot(r, r) * dot(v, v))))};
}

const auto kSpecular = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    const Reflection<T> r = reflect<T>(in);
    if (r.nl <= 0 || r.cosine <= 0) return T(0);
    using std::log;
    const T x = in[9] * log(r.cosine);
    return x < -87.3 ? T(0) : T(exp(x));
};

// On the terminator, N.L = 0, the factor jumps: within the rounding of N.L either side is right.
double specular_bound(std::span<const float> in, double expected) {
    const std::vector<double> wide(in.begin(), in.end());
    const Reflection<double> r = reflect<double>(wide);
    if (std::abs(r.nl) < 4 * kU) return 1.0;
    if (r.cosine < 0.5) return 16 * kU;
    const double n = wide[9], x = std::abs(n * std::log(r.cosine));
    return (8 + 4 * x + 4 * std::sqrt(2 * n * x)) * kU * expected + 1.3e-38;
}

void put(std::span<float> out, const double (&v)[3]) {
    const double length = std::hypot(v[0], v[1], v[2]);
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i] / length);
}

// A lit normal, and a viewer at any small or large angle from the mirror direction; exponents that leave something to see there.
void fill_highlight(Random& random, std::span<float> in) {
    double n[3], l[3], v[3];
    unit_vector(random, n);
    unit_vector(random, l);
    unit_vector(random, v);
    const double side = n[0] * l[0] + n[1] * l[1] + n[2] * l[2] < 0 ? -1 : 1;
    for (double& c : l) c *= side;
    const double nl = n[0] * l[0] + n[1] * l[1] + n[2] * l[2], away = log_uniform(random, 1e-6, 3);
    for (int i = 0; i < 3; ++i) v[i] = 2 * nl * n[i] - l[i] + away * v[i];
    put(in.subspan(0, 3), n);
    put(in.subspan(3, 3), l);
    put(in.subspan(6, 3), v);
    in[9] = static_cast<float>(log_uniform(random, 1, std::min(1e6, 1 + 40 / (away * away))));
}

Inputs two_units(std::size_t count, unsigned seed) {
    const auto up = only({0}) * only({0}) * only({1}), side = only({1}) * only({0}) * only({0}), down = only({0}) * only({0}) * only({-1});
    return generate(count, 6, seed,
                    [](Random& random, std::span<float> in) {
                        double d[3];
                        unit_vector(random, d);
                        put(in.subspan(0, 3), d);
                        unit_vector(random, d);
                        put(in.subspan(3, 3), d);
                    }) +
           up * side + up * down;
}

} // namespace

Rows phong_rows() {
    const Oracle lambert = oracle([](auto in) {
        const auto c = dot(in.first(3), in.subspan(3, 3));
        return c <= 0 ? decltype(c)(0) : c;
    });
    return {{"lambert", "lib/phong.glsl", "n, l unit", "lambert", 1, two_units, {{"", "absolute 3 u", lambert, Bound::absolute(3 * kU)}}},
            {"phong_specular",
             "lib/phong.glsl",
             "n, l, v unit, N.L >= 0, shininess in [1, 1e6]",
             "phong_specular",
             1,
             [](std::size_t count, unsigned seed) { return generate(count, 10, seed, fill_highlight); },
             {{"", "relative (8 + 4|x| + 4 sqrt(2n|x|)) u, x = n ln(R.V); R.V < 1/2: absolute 16 u", oracle(kSpecular),
               Bound::function(specular_bound)}}}};
}

} // namespace lightbench::kernels
