// Rays as oracles see them: points of a line in double, extremes and roots of functions along it by sections alone.
#pragma once

#include "inputs.h"

#include <array>
#include <cmath>

namespace lightbench::kernels {

constexpr double kNoHit = static_cast<double>(3.4028235e38f);

using Vector = std::array<double, 3>;

inline Vector vector_at(std::span<const float> values, std::size_t first) {
    return {static_cast<double>(values[first]), static_cast<double>(values[first + 1]), static_cast<double>(values[first + 2])};
}

inline double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double length(const Vector& v) {
    return std::hypot(v[0], v[1], v[2]);
}

inline Vector plus(const Vector& a, const Vector& b, double factor = 1) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

inline Vector scaled(const Vector& v, double factor) {
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

inline void put(std::span<float> out, const Vector& v) {
    for (std::size_t i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i]);
}

inline Vector random_unit(Random& random) {
    Vector v{};
    unit_vector(random, v);
    return v;
}

struct Line {
    Vector o, d;
    Vector at(double t) const { return plus(o, d, t); }
    double nearest() const { return -dot(o, d) / dot(d, d); } // t of the point closest to the centre
};

inline Line line_of(std::span<const float> in) {
    return {vector_at(in, 0), vector_at(in, 3)};
}

// Where f is least between low and high, f having one minimum there. Golden section (Kiefer 1953).
template <class F> double least_between(double low, double high, F f) {
    constexpr double kGolden = 0.6180339887498949;
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low), fa = f(a), fb = f(b);
    for (int i = 0; i < 80; ++i) {
        const bool left = fa < fb;
        (left ? high : low) = left ? b : a;
        (left ? b : a) = left ? a : b;
        (left ? fb : fa) = left ? fa : fb;
        (left ? a : b) = left ? high - kGolden * (high - low) : low + kGolden * (high - low);
        (left ? fa : fb) = left ? f(a) : f(b);
    }
    return fa < fb ? a : b;
}

// Where f changes its sign between a and b.
template <class F> double root_between(double a, double b, F f) {
    const bool negative = f(a) < 0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (a + b);
        ((f(middle) < 0) == negative ? a : b) = middle;
    }
    return 0.5 * (a + b);
}

// o and d of a ray that starts at a distance of 0.01 to 10^4 from the centre and is aimed at a point within reach of it; |d| is anything.
inline void fill_ray(Random& random, std::span<float> in, double reach) {
    const Vector o = scaled(random_unit(random), log_uniform(random, 1e-2, 1e4));
    const Vector target = scaled(random_unit(random), reach * std::cbrt(uniform(random, 0, 1)));
    put(in.first(3), o);
    const Vector d = plus(target, o, -1);
    put(in.subspan(3, 3), scaled(d, log_uniform(random, 1e-6, 1e6) / length(d)));
}

} // namespace lightbench::kernels
