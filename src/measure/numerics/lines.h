// Rays as oracles see them: points of a line in double, extremes and roots of functions along it by sections alone.
#pragma once

#include "measure/numerics/rays.h"

namespace lightbench::kernels {

// Any direction, a length from low to high.
inline Vec3 random_at(Random& random, double low, double high) {
    const Vec3 direction = random_direction(random);
    return log_uniform(random, low, high) * direction;
}

struct Line {
    Vec3 o, d;
    Vec3 at(double t) const { return o + t * d; }
    double nearest() const { return -dot(o, d) / dot(d, d); } // t of the point closest to the centre
};

inline Line line_of(std::span<const float> in) {
    return {vec_of(in, 0), vec_of(in, 3)};
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
    const Vec3 o = random_at(random, 1e-2, 1e4), aim = random_direction(random);
    const Vec3 d = unit(reach * std::cbrt(uniform(random, 0, 1)) * aim - o);
    put(in, 0, o);
    put(in, 3, log_uniform(random, 1e-6, 1e6) * d);
}

// i and n, unit; the angle between -i and n.
inline void fill_incidence(Random& random, std::span<float> in, double angle) {
    const Vec3 n = random_direction(random), any = random_direction(random), along = unit(any - dot(n, any) * n);
    put(in, 0, std::sin(angle) * along - std::cos(angle) * n);
    put(in, 3, n);
}

} // namespace lightbench::kernels
