// Point-to-polygon form factors against the area integral, clipped at the horizon: HC-3, HC-10.
#include "measure/numerics/rays.h"
#include "measure/numerics/rows.h"

namespace lightbench::kernels {

namespace {

// (n, q0 ... q3): a plane quadrilateral or triangle somewhere about the point, of any size, turned to it; a quarter of them straddle its horizon.
void fill_quad(Random& random, std::span<float> in) {
    const Vec3 n = random_direction(random), way = unit(n + 0.99 * random_direction(random));
    const double distance = log_uniform(random, 1e-2, 1), size = distance * log_uniform(random, 1e-2, 3);
    const Vec3 center = distance * (random() % 4 ? way : unit(cross(n, random_direction(random))));
    const Vec3 axis = unit(random_direction(random) - 1.0 * unit(center)); // towards the point, more or less
    const Vec3 u = unit(cross(axis, random_direction(random))), v = cross(axis, u);
    const double x0 = uniform(random, 0.2, 1), x1 = uniform(random, 0.2, 1), y0 = uniform(random, 0.2, 1), y1 = uniform(random, 0.2, 1);
    put(in, 0, n);
    put(in, 3, center - (size * x0) * u);
    put(in, 6, center - (size * y0) * v);
    put(in, 9, center + (size * x1) * u);
    put(in, 12, random() % 8 ? center + (size * y1) * v : center + (size * x1) * u);
}

// Lambert's sum over the corners that are above the horizon, with angles between unit vectors by atan2. (That the sum is the integral is held
// to Howell's catalogue by the unit tests of src/radiosity/form_factors.h.)
template <class T> T lambert(std::span<const T> in) {
    using std::acos, std::abs;
    std::vector<Vec<T>> corners, kept;
    const Vec<T> n = vec_at(in, 0);
    for (std::size_t k = 3; k < 15; k += 3) corners.push_back(vec_at(in, k));
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec<T>&a = corners[i], &b = corners[(i + 1) % 4];
        const T ha = dot(n, a), hb = dot(n, b);
        if (ha > 0) kept.push_back(a);
        if ((ha > 0) != (hb > 0)) kept.push_back(a + T(ha / (ha - hb)) * (b - a));
    }
    T sum = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        using std::atan2;
        const Vec<T> a = unit(kept[i]), b = unit(kept[(i + 1) % kept.size()]), across = cross(a, b);
        const T sine = length(across);
        if (sine > 0) sum -= atan2(sine, dot(a, b)) * dot(n, across) / sine;
    }
    const T value = sum / (2 * acos(T(-1)));
    return value > 0 ? value : T(0);
}

} // namespace

Rows form_factor_rows() {
    const Oracle tangent = oracle([](auto in) {
        using std::atan;
        return decltype(in[0] + 0)(atan(in[0]));
    });
    const Oracle factor = oracle([](auto x) {
        using T = std::remove_cvref_t<decltype(x[0])>;
        return lambert<T>(x);
    });
    return {
        {"arc_tangent",
         "lib/form_factor.glsl",
         "x in [0, 1e30]",
         "arc_tangent",
         1,
         [](std::size_t count, unsigned) { return grid(0, 4, count / 4) + log_grid(1e-30, 1e30, count / 16) + near(1, 1000) + only({0}); },
         {{"", "relative 8 u", tangent, Bound::relative(8 * kU)}}},
        {"point_to_quad",
         "lib/form_factor.glsl",
         "any size and place, across the horizon too",
         "point_to_quad",
         1,
         [](std::size_t count, unsigned seed) { return generate(count, 15, seed, fill_quad); },
         {{"", "absolute 3e-6", factor, Bound::absolute(3e-6)}}}};
}

} // namespace lightbench::kernels
