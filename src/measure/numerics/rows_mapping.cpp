// Mappings of space to texture coordinates against arc tangents in double: TX-3, TX-4, TX-5, EN-1.
#include "measure/numerics/rows.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lightbench::kernels {

namespace {

constexpr double kPi = std::numbers::pi;

// Distance on the circle of circumference 1.
double around(double difference) {
    return std::abs(difference - std::round(difference));
}

// atan2 knows the signs of zeros; here the axis is at 0 in any case.
double azimuth(double y, double x) {
    return x == 0 && y == 0 ? 0 : std::atan2(y, x) / (2 * kPi);
}

double polar_v(std::span<const float> p) {
    return 1 - std::atan2(std::hypot(static_cast<double>(p[0]), static_cast<double>(p[1])), static_cast<double>(p[2])) / kPi;
}

// How far result i is from the azimuth; 2 if it is not in [0, 1).
Measure off_azimuth(std::size_t i) {
    return [=](std::span<const float> p, std::span<const float> out) {
        if (!(out[i] >= 0 && out[i] < 1)) return 2.0;
        return around(static_cast<double>(out[i]) - azimuth(static_cast<double>(p[1]), static_cast<double>(p[0])));
    };
}

// Points of the box: everywhere, near the axis, near the middle.
Inputs points(std::size_t count, unsigned seed) {
    const Inputs box = generate(count, 3, seed, [](Random& random, std::span<float> p) {
        for (float& x : p) x = static_cast<float>(uniform(random, -1, 1));
    });
    const Inputs axis = generate(count / 4, 3, seed + 100, [](Random& random, std::span<float> p) {
        double d[3];
        unit_vector(random, d);
        const double away = log_uniform(random, 1e-12, 1);
        p[0] = static_cast<float>(d[0] * away);
        p[1] = static_cast<float>(d[1] * away);
        p[2] = static_cast<float>(d[2]);
    });
    const Inputs corners = only({0.0f, -0.0f, 1, -1, 0.41421357f, 1e-12f, -1e-12f});
    return box + axis + corners * corners * corners;
}

double length_of(std::span<const double> v) {
    return std::hypot(v[0], v[1], v[2]);
}

// Gradient of a function of space by central differences in double; off by 1e-8 of its length where p is not within 1e-3 of the axis.
template <class F> std::array<double, 3> gradient(F f, std::span<const float> p) {
    const double step = 1e-5 * std::hypot(static_cast<double>(p[0]), static_cast<double>(p[1]));
    std::array<double, 3> g{};
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<double, 3> a{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])}, b = a;
        a[i] -= step, b[i] += step;
        double change = f(b) - f(a);
        change -= std::round(change); // the seam
        g[i] = change / (2 * step);
    }
    return g;
}

// Error of the gradient at result i, as a share of its length.
template <class F> Measure off_gradient(F f, std::size_t i) {
    return [=](std::span<const float> p, std::span<const float> out) {
        const std::array<double, 3> g = gradient(f, p);
        std::array<double, 3> miss{};
        for (std::size_t k = 0; k < 3; ++k) miss[k] = g[k] - static_cast<double>(out[i + k]);
        return length_of(miss) / length_of(g);
    };
}

double off_turns(std::span<const float> in, std::span<const float> out) {
    if (!(out[0] >= 0 && out[0] < 1)) return 2.0;
    const double y = static_cast<double>(in[0]), x = static_cast<double>(in[1]), low = std::min(std::abs(y), std::abs(x));
    const double flushed = low < 0x1p-126 ? low / (2 * kPi * std::max(std::abs(y), std::abs(x))) : 0; // it may count as 0
    const double missed = around(static_cast<double>(out[0]) - azimuth(y, x));
    return low > 0 ? std::max(0.0, missed - flushed) : missed;
}

Inputs angles(std::size_t count, unsigned seed) {
    const Inputs in = generate(count, 2, seed, [](Random& random, std::span<float> yx) {
        const double angle = uniform(random, 0, 2 * kPi), length = log_uniform(random, 1e-30, 1e37), away = log_uniform(random, 1e-9, 1);
        yx[0] = static_cast<float>(length * std::sin(angle) * away);
        yx[1] = static_cast<float>(length * std::cos(angle));
    });
    const Inputs axis = near(1, 100) + near(-1, 100) + near(0.41421356f, 100) + only({0.0f, -0.0f, 1e-37f, -1e-37f, 1e38f});
    return in + axis * axis;
}

Inputs off_axis(std::size_t count, unsigned seed) {
    return generate(count / 4, 3, seed, [](Random& random, std::span<float> p) {
        double d[3];
        do unit_vector(random, d);
        while (std::hypot(d[0], d[1]) < 1e-3);
        const double length = log_uniform(random, 1e-6, 1e3);
        for (std::size_t i = 0; i < 3; ++i) p[i] = static_cast<float>(d[i] * length);
    });
}

double off_latitude(std::span<const float> p, std::span<const float> out) {
    const bool middle = p[0] == 0 && p[1] == 0 && p[2] == 0;
    return static_cast<double>(out[1]) - (middle ? 1 : polar_v(p));
}

// The i-th coordinate from -1 to 1 as texture coordinate.
Claim straight(const char* what, std::size_t i, std::size_t result) {
    return {what, "absolute 2 u", oracle([=](auto p) { return p[i] / 2 + 0.5; }), Bound::absolute(2 * kU), component(result)};
}

Claim round_claim(const char* what, std::size_t result) {
    return {what, "absolute 1.5 u, in [0, 1)", constant(0), Bound::absolute(1.5 * kU), off_azimuth(result)};
}

double off_panorama_u(std::span<const float> d, std::span<const float> out) {
    const double u = 0.5 + azimuth(static_cast<double>(d[0]), -static_cast<double>(d[2]));
    const double difference = static_cast<double>(out[0]) - (d[0] == 0 && d[2] == 0 ? 0 : u);
    return out[0] >= 0 && out[0] < 1 ? around(difference) : 2;
}

double off_panorama_v(std::span<const float> d, std::span<const float> out) {
    const double away = std::hypot(static_cast<double>(d[0]), static_cast<double>(d[2]));
    return static_cast<double>(out[1]) - (1 - std::atan2(away, static_cast<double>(d[1])) / kPi);
}

Inputs panorama_directions(std::size_t count, unsigned seed) {
    const Inputs axis = only({0.0f, -0.0f, 1, -1, 1e-6f, -1e-6f});
    return generate(count / 2, 3, seed,
                    [](Random& random, std::span<float> v) {
                        double d[3];
                        unit_vector(random, d);
                        const double length = log_uniform(random, 1e-30, 1e30);
                        for (std::size_t i = 0; i < 3; ++i) v[i] = static_cast<float>(d[i] * length);
                    }) +
           axis * axis * (near(1, 1) + near(-1, 1));
}

Row gradient_row() {
    const auto u = [](std::array<double, 3> p) { return azimuth(p[1], p[0]); };
    const auto v = [](std::array<double, 3> p) { return 1 - std::atan2(std::hypot(p[0], p[1]), p[2]) / kPi; };
    const Bound bound = Bound::absolute(8 * kU);
    return {"mapping gradients",
            "lib/mapping.glsl",
            "|p| in [1e-6, 1e3], not within 1e-3 of the axis",
            "mapping_gradients",
            18,
            off_axis,
            {{"spherical u", "relative 8 u", constant(0), bound, off_gradient(u, 0)},
             {"spherical v", "relative 8 u", constant(0), bound, off_gradient(v, 3)},
             {"cylindrical u", "relative 8 u", constant(0), bound, off_gradient(u, 6)}}};
}

} // namespace

Rows mapping_rows() {
    return {{"turns",
             "lib/mapping.glsl",
             "y, x to 1e37, the axes",
             "turns",
             1,
             angles,
             {{"", "absolute 1.5 u, in [0, 1)", constant(0), Bound::absolute(1.5 * kU), off_turns}}},
            {"map_spherical, map_cylindrical, map_planar",
             "lib/mapping.glsl",
             "the cube of side 2, the axis",
             "mapping",
             6,
             points,
             {round_claim("spherical u", 0),
              {"spherical v", "absolute 4 u", constant(0), Bound::absolute(4 * kU), off_latitude},
              round_claim("cylindrical u", 2),
              straight("cylindrical v", 2, 3),
              straight("planar u", 0, 4),
              straight("planar v", 1, 5)}},
            gradient_row(),
            {"equirect_uv",
             "lib/environment.glsl",
             "|d| in [1e-30, 1e30], the axes",
             "equirect_uv",
             2,
             panorama_directions,
             {{"u", "absolute 1.5 u, in [0, 1)", constant(0), Bound::absolute(1.5 * kU), off_panorama_u},
              {"v", "absolute 4 u", constant(0), Bound::absolute(4 * kU), off_panorama_v}}}};
}

} // namespace lightbench::kernels
