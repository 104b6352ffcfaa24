// Vectors and random rays for the tests of ray intersections.
#pragma once

#include "measure/numerics/facets.h"

#include <algorithm>

namespace lightbench::kernels {

constexpr double kNoHit = static_cast<double>(kFloatMax); // lib/ray.glsl

using Vec3 = Vec<double>;
template <class T> Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T> Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T> Vec<T> operator*(const T& s, const Vec<T>& a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class T> T largest(const Vec<T>& a) {
    using std::abs, std::max;
    return max(T(abs(a.x)), max(T(abs(a.y)), T(abs(a.z))));
}

inline Vec3 vec_of(std::span<const float> in, std::size_t at) {
    return {static_cast<double>(in[at]), static_cast<double>(in[at + 1]), static_cast<double>(in[at + 2])};
}
inline void put(std::span<float> to, std::size_t at, const Vec3& v) {
    to[at] = static_cast<float>(v.x);
    to[at + 1] = static_cast<float>(v.y);
    to[at + 2] = static_cast<float>(v.z);
}
inline Vec3 random_direction(Random& random) {
    double d[3];
    unit_vector(random, d);
    return {d[0], d[1], d[2]};
}
inline Vec3 random_in_cube(Random& random, double half) {
    return {uniform(random, -half, half), uniform(random, -half, half), uniform(random, -half, half)};
}

// What a result is over what it may be: for constant(0) and Bound::absolute(1).
inline double over(double off, double allowed) {
    return off == 0 ? 0 : off / allowed;
}

} // namespace lightbench::kernels
