// Lambert's and Phong's factors against their formulas in double and 60 digits: LI-1, LI-2, LI-3.
#include "kernel_test.h"

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

const Oracle kSpecular = oracle([](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    const Reflection<T> r = reflect<T>(in);
    if (r.nl <= 0 || r.cosine <= 0) return T(0);
    using std::log;
    const T x = in[9] * log(r.cosine);
    return x < -87.3 ? T(0) : T(exp(x));
});

// As phong.glsl states it. On the terminator, N.L = 0, the factor jumps: within the rounding of N.L either side is right.
const Bound kSpecularBound = Bound::function([](std::span<const float> in, double expected) {
    const std::vector<double> wide(in.begin(), in.end());
    const Reflection<double> r = reflect<double>(wide);
    if (std::abs(r.nl) < 4 * kU) return 1.0;
    if (r.cosine < 0.5) return 16 * kU;
    const double n = wide[9], x = std::abs(n * std::log(r.cosine));
    return (8 + 4 * x + 4 * std::sqrt(2 * n * x)) * kU * expected + 1.3e-38;
});

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

Inputs vec(float x, float y, float z) {
    return only({x}) * only({y}) * only({z});
}

Inputs random_units(std::size_t count, unsigned seed, bool below) {
    return generate(count, 3, seed, [=](Random& random, std::span<float> v) {
        double d[3];
        unit_vector(random, d);
        if (below) d[2] = -std::abs(d[2]);
        put(v, d);
    });
}

} // namespace

TEST_F(Kernel, Lambert) {
    const Oracle lambert = oracle([](auto in) {
        const auto c = dot(in.first(3), in.subspan(3, 3));
        return c <= 0 ? decltype(c)(0) : c;
    });
    for (unsigned seed : seeds()) {
        const Inputs in = random_units(1024, seed, false) * random_units(1024, seed + 100, false) + vec(0, 0, 1) * vec(1, 0, 0) +
                          vec(0, 1, 0) * vec(0, -1, 0);
        expect_within(run_kernel(device, "lambert", in), lambert, Bound::absolute(3 * kU));
    }
}

TEST_F(Kernel, PhongSpecular) {
    for (unsigned seed : seeds()) {
        const Inputs in = generate(kMillion, 10, seed, fill_highlight);
        expect_within(run_kernel(device, "phong_specular", in), kSpecular, kSpecularBound);
    }
}

// LI-2: the corners of 0^0, 0^n and (negative)^n, by geometry that is exact in float.
TEST_F(Kernel, SpecularSpecialValues) {
    const Inputs up = vec(0, 0, 1), side = vec(1, 0, 0), down = vec(0, 0, -1), slant = vec(0.6f, 0, 0.8f), mirror = vec(-0.6f, 0, 0.8f);
    const Inputs exponents = only({0, 1e-30f, 1, 200, 1000, 100000, 1e20f, kFloatMax});
    const Inputs full = up * (up * up + slant * mirror + mirror * slant) * exponents; // R = V
    expect_within(run_kernel(device, "phong_specular", full), constant(1), Bound::exact());
    const Inputs none = up * (up * side + up * down + down * up + side * mirror + down * slant) * exponents;
    expect_within(run_kernel(device, "phong_specular", none), constant(0), Bound::exact());
    const Inputs flat = up * up * slant * only({0}) + up * slant * up * only({0}); // lit, R.V > 0, n = 0
    expect_within(run_kernel(device, "phong_specular", flat), constant(1), Bound::exact());
}

// LI-3: no highlight leaks through a surface that is lit from behind, though R.V may be 1 there.
TEST_F(Kernel, NoHighlightFromBehind) {
    const Inputs in = vec(0, 0, 1) * random_units(1024, 1, true) * random_units(1024, 2, false) * only({1});
    expect_within(run_kernel(device, "phong_specular", in), constant(0), Bound::exact());
}

TEST_F(Kernel, PhongKeepsNaN) {
    const Inputs bad = vec(kNaN, 0, 1), up = vec(0, 0, 1);
    const Oracle nan = constant(static_cast<double>(kNaN));
    const Inputs in = (bad * up * up + up * bad * up + up * up * bad) * only({0, 1, 1000}) + up * up * up * only({kNaN});
    expect_within(run_kernel(device, "phong_specular", in), nan, Bound::exact());
    expect_within(run_kernel(device, "lambert", bad * up + up * bad), nan, Bound::exact());
}

} // namespace lightbench::kernels
