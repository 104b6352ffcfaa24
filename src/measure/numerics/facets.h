// Cook-Torrance as SPEC S6 writes it, in any number type, and inputs for it. Written from the angles, as the kernels are not.
#pragma once

#include "measure/numerics/verdict.h"

#include <cmath>
#include <numbers>

namespace lightbench::kernels {

enum class Facets { gaussian, beckmann };
inline const char* kernel_of(Facets d) {
    return d == Facets::gaussian ? "cook_torrance_gaussian" : "cook_torrance_beckmann";
}

template <class T> struct Vec {
    T x, y, z;
};
template <class T> T dot(const Vec<T>& a, const Vec<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T> Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> Vec<T> sum(const Vec<T>& a, const Vec<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T> T length(const Vec<T>& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}
template <class T> Vec<T> unit(const Vec<T>& a) {
    const T l = length(a);
    return {a.x / l, a.y / l, a.z / l};
}
template <class T> Vec<T> vec_at(std::span<const T> in, std::size_t at) {
    return {in[at], in[at + 1], in[at + 2]};
}

template <class T> struct FacetTerms {
    T nl, nv, exponent; // D = lobe * spread * exp(-exponent)
    T spread, open, fresnel;
    T value() const {
        using std::exp;
        return exponent > 87.3 ? T(0) : spread * exp(-exponent) * open * fresnel;
    }
};

template <class T> T fresnel_of_angle(T phi, T n) {
    using std::asin, std::sin, std::tan;
    if (n == 1) return 0;
    if (phi < 1e-9) return (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    const T theta = asin(sin(phi) / n), s = sin(phi - theta) / sin(phi + theta), p = tan(phi - theta) / tan(phi + theta);
    return (s * s + p * p) / 2;
}

// (n, l, v, m, lobe, ior). H is the direction of L + V as they are given; the angles forgive that vectors are unit in float only.
template <class T> FacetTerms<T> facet_terms(Facets d, std::span<const T> in) {
    using std::atan2, std::cos, std::tan, std::min;
    const Vec<T> n = unit(vec_at(in, 0)), l = unit(vec_at(in, 3)), v = unit(vec_at(in, 6));
    const Vec<T> h = unit(sum(vec_at(in, 3), vec_at(in, 6)));
    const T m = in[9], nl = dot(n, l), nv = dot(n, v), nh = dot(n, h);
    const T alpha = atan2(length(cross(n, h)), nh), phi = atan2(length(sum(l, Vec<T>{-v.x, -v.y, -v.z})), length(sum(l, v)));
    const T vh = cos(phi); // H halves the angle between L and V
    const T slope = d == Facets::gaussian ? alpha : T(tan(alpha)), cosine = cos(alpha);
    const T spread = d == Facets::gaussian ? in[10] : T(in[10] / (cosine * cosine * cosine * cosine));
    const T g = min(T(1), min(T(2 * nh * nv / vh), T(2 * nh * nl / vh)));
    return {nl, nv, T(slope * slope / (m * m)), spread, T(g / nv), fresnel_of_angle(phi, T(in[11]))};
}

// As a surface in a picture: lit and seen, with a facet that turns some light to the viewer. alpha^2/m^2 from 0 to 20.
void fill_facet(Random& random, std::span<float> in, Facets d);

// Vectors whose products with the normal (0, 0, 1) are exact, however small.
std::vector<float> exact_geometry(float nl, float nv, double azimuth, float m, float lobe, float ior);

} // namespace lightbench::kernels
