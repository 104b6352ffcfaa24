// Rays against triangles: t and barycentrics against determinants in double and 60 digits: PL-5, PL-6.
#include "measure/numerics/rays.h"
#include "measure/numerics/rows.h"

namespace lightbench::kernels {

namespace {

// (o, d, v0, v1, v2, after): Cramer's rule on o + t d = v0 + b1 (v1 - v0) + b2 (v2 - v0).
template <class T> struct Meeting {
    T t, b1, b2;
    Vec<T> u, v, normal; // edges from v0, twice the area
};
template <class T> Meeting<T> meeting(std::span<const T> in) {
    const Vec<T> o = vec_at(in, 0), d = vec_at(in, 3), v0 = vec_at(in, 6), u = vec_at(in, 9) - v0, v = vec_at(in, 12) - v0;
    const Vec<T> normal = cross(u, v), w = o - v0, q = cross(w, d);
    const T determinant = -dot(d, normal);
    return {T(dot(w, normal) / determinant), T(dot(v, q) / determinant), T(-dot(u, q) / determinant), u, v, normal};
}

// What rounding may do: vertices are off by 16 u of the largest coordinate relative to o, edge functions by 4 u of their products.
struct Doubt {
    double t, b;
};
Doubt doubt(std::span<const double> in, const Meeting<double>& m) {
    const Vec3 o = vec_at(in, 0), d = unit(vec_at(in, 3)), corner = vec_at(in, 6) - o;
    const double reach = std::max({largest(corner), largest(corner + m.u), largest(corner + m.v)}), area = length(m.normal);
    const double longest = std::max({length(m.u), length(m.v), length(m.u - m.v)});
    const double cosine = std::abs(dot(m.normal, d)) / area, off = 16 * kU * (reach + longest * longest * longest / area) / cosine;
    return {off / length(vec_at(in, 3)), off * longest / area};
}

bool hits(const Meeting<double>& m, double margin) {
    return m.b1 > margin && m.b2 > margin && m.b1 + m.b2 < 1 - margin;
}
bool may_hit(const Meeting<double>& m, double margin) {
    return !(m.b1 < -margin || m.b2 < -margin || m.b1 + m.b2 > 1 + margin);
}

// 0: as it must be; a number above 1: not. Between: t as a share of what it may be off.
double share_of_t(std::span<const float> tuple, std::span<const float> out) {
    const std::vector<double> in(tuple.begin(), tuple.end());
    const Meeting<double> m = meeting(std::span<const double>(in));
    if (length(m.normal) == 0) return 0; // rounding has made it a line
    const Doubt off = doubt(in, m);
    const bool hit = out[0] < kFloatMax;
    if (!hit) return hits(m, off.b) && m.t > in[15] + off.t ? 1e3 : 0;
    if (!may_hit(m, off.b) || m.t < in[15] - off.t) return 1e6;
    return over(std::abs(static_cast<double>(out[0]) - m.t), off.t);
}
double share_of_b(std::span<const float> tuple, std::span<const float> out) {
    const std::vector<double> in(tuple.begin(), tuple.end());
    const Meeting<double> m = meeting(std::span<const double>(in));
    if (!(out[0] < kFloatMax) || length(m.normal) == 0) return 0;
    const double off = std::max(std::abs(static_cast<double>(out[1]) - m.b1), std::abs(static_cast<double>(out[2]) - m.b2));
    return over(off, doubt(in, m).b + 4 * kU);
}

// How far from the plane, as a share of what the error of the point lets it be (PL-5).
double share_of_plane(std::span<const float> tuple, std::span<const float> out) {
    const std::vector<double> in(tuple.begin(), tuple.end());
    const Meeting<double> m = meeting(std::span<const double>(in));
    if (!(out[0] < kFloatMax)) return 0;
    const Vec3 e = vec_of(out, 6), w = vec_of(out, 3) - vec_of(tuple, 6), n = m.normal;
    return over(std::abs(dot(w, n)), std::abs(n.x) * e.x + std::abs(n.y) * e.y + std::abs(n.z) * e.z);
}

// Triangles of any size and place; thin: squashed towards one edge.
Inputs triangles(std::size_t count, unsigned seed, double thin) {
    return generate(count, 16, seed, [=](Random& random, std::span<float> in) {
        const double size = log_uniform(random, 1e-3, 1e3), far = size * log_uniform(random, 0.1, 1e3);
        const Vec3 v0 = random_in_cube(random, far), v1 = v0 + size * random_direction(random);
        const Vec3 v2 = v0 + uniform(random, 0, 1) * (v1 - v0) + (size * log_uniform(random, thin, 1)) * random_direction(random);
        const double a = uniform(random, -0.2, 1), b = uniform(random, -0.2, 1);
        const Vec3 o = random_in_cube(random, far), aim = v0 + a * (v1 - v0) + b * (v2 - v0);
        put(in, 0, o);
        put(in, 3, unit(aim - o));
        put(in, 6, v0);
        put(in, 9, v1);
        put(in, 12, v2);
        in[15] = 0;
    });
}

Row triangle_row(const std::string& domain, double thin) {
    return {"ray_triangle",
            "lib/ray_triangle.glsl",
            domain,
            "ray_triangle",
            9,
            [=](std::size_t count, unsigned seed) { return triangles(count / 2, seed, thin); },
            {{"hit and t", "vertices off by 16 u of the largest coordinate", constant(0), Bound::absolute(1), share_of_t},
             {"barycentrics", "vertices off by 16 u, and 4 u", constant(0), Bound::absolute(1), share_of_b},
             {"point", "within its error of the plane", constant(0), Bound::absolute(1), share_of_plane}}};
}

// The oracle in double is as good as in 60 digits: t of triangles that are not thin.
Claim t_claim() {
    const Oracle t = oracle([]<class T>(std::span<const T> in) { return meeting(in).t; });
    const Bound bound = Bound::function([](std::span<const float> tuple, double) {
        const std::vector<double> in(tuple.begin(), tuple.end());
        return doubt(in, meeting(std::span<const double>(in))).t;
    });
    return {"t", "as t, against 60 digits", t, bound, [](std::span<const float> tuple, std::span<const float> out) {
                const std::vector<double> in(tuple.begin(), tuple.end());
                return out[0] < kFloatMax ? static_cast<double>(out[0]) : meeting(std::span<const double>(in)).t;
            }};
}

} // namespace

Rows triangle_rows() {
    Row plain = triangle_row("any size and place, not thin", 0.1);
    plain.claims.push_back(t_claim());
    return {plain, triangle_row("as thin as 1e-6 of their length", 1e-6)};
}

} // namespace lightbench::kernels
