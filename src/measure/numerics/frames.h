// Frames at surfaces: random ones, and the vectors in double that their oracles reckon with. Inside this folder and the kernels' tests.
#pragma once

#include "measure/numerics/inputs.h"

#include <array>
#include <cmath>
#include <span>

namespace lightbench::kernels::frames {

using Vector = std::array<double, 3>;

inline Vector at(std::span<const float> values, std::size_t first) {
    return {static_cast<double>(values[first]), static_cast<double>(values[first + 1]), static_cast<double>(values[first + 2])};
}

inline double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double length(const Vector& v) {
    return std::hypot(v[0], v[1], v[2]);
}

inline Vector plus(const Vector& a, const Vector& b, double factor) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

inline Vector unit(const Vector& v) {
    return plus({0, 0, 0}, v, 1 / length(v));
}

inline void put(std::span<float> out, const Vector& v) {
    for (std::size_t i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i]);
}

inline Vector random_unit(Random& random) {
    Vector v{};
    unit_vector(random, v);
    return v;
}

// Some n, a t at any small angle from n or its opposite, of any length; both handednesses.
inline void fill_frame(Random& random, std::span<float> in) {
    const Vector n = random_unit(random);
    const double side = uniform(random, -1, 1) < 0 ? -1 : 1, along = uniform(random, -1, 1) < 0 ? side : 0;
    const Vector t = plus(plus({0, 0, 0}, n, along), random_unit(random), log_uniform(random, 1e-9, 1));
    put(in.subspan(0, 3), n);
    put(in.subspan(3, 3), plus({0, 0, 0}, t, log_uniform(random, 1e-20, 1e20)));
    in[6] = uniform(random, -1, 1) < 0 ? -1.0f : 1.0f;
}

} // namespace lightbench::kernels::frames
