// Gradient noise, waves and the checkerboard against their definitions in double and 60 digits.
#include "measure/numerics/rows.h"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <fmt/format.h>

namespace lightbench::kernels {

namespace {

using Point = std::array<std::uint32_t, 3>;

// Jarzynski, Olano 2020, pcg3d.
std::uint32_t hash(Point v) {
    for (std::uint32_t& x : v) x = x * 1664525u + 1013904223u;
    const auto stir = [&] {
        v[0] += v[1] * v[2];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
    };
    stir();
    for (std::uint32_t& x : v) x ^= x >> 16;
    stir();
    return v[0];
}

// The two axes that a direction to an edge has parts along, and their signs.
std::array<int, 3> edge(const Point& point) {
    const std::uint32_t k = (hash(point) >> 16) * 12 / 65536;
    const std::array<std::array<std::size_t, 2>, 3> axes{{{0, 1}, {0, 2}, {1, 2}}};
    std::array<int, 3> g{};
    g[axes[k / 4][0]] = k % 2 == 0 ? 1 : -1;
    g[axes[k / 4][1]] = k / 2 % 2 == 0 ? 1 : -1;
    return g;
}

// One corner's weight along an axis, and the weight's derivative. t: from the cell's lower side.
template <class T> std::array<T, 2> weight(T t, bool upper) {
    const T s = t * t * t * (t * (6 * t - 15) + 10), ds = 30 * t * t * (1 - t) * (1 - t);
    return upper ? std::array<T, 2>{s, ds} : std::array<T, 2>{T(1 - s), T(-ds)};
}

// The sum over the eight corners of weight times plane; result 3 is the value, 0 to 2 its derivatives by the product rule.
template <class T> T noise_sum(std::span<const T> q, std::size_t result) {
    std::array<T, 3> f{};
    std::array<long, 3> low{};
    for (std::size_t i = 0; i < 3; ++i) {
        using std::floor;
        low[i] = static_cast<long>(floor(q[i]));
        f[i] = q[i] - low[i];
    }
    T sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Point point{};
        std::array<std::array<T, 2>, 3> w;
        std::array<T, 3> away{};
        for (std::size_t i = 0; i < 3; ++i) {
            const int upper = corner >> i & 1;
            point[i] = static_cast<std::uint32_t>((low[i] + upper) & 65535);
            w[i] = weight(f[i], upper != 0);
            away[i] = f[i] - upper;
        }
        const std::array<int, 3> g = edge(point);
        const T plane = g[0] * away[0] + g[1] * away[1] + g[2] * away[2];
        const T whole = w[0][0] * w[1][0] * w[2][0];
        if (result == 3) {
            sum += whole * plane;
        } else {
            const std::size_t j = (result + 1) % 3, k = (result + 2) % 3;
            sum += whole * g[result] + w[result][1] * w[j][0] * w[k][0] * plane;
        }
    }
    return sum * T(0.96f);
}

Oracle noise(std::size_t result) {
    return oracle([=](auto q) { return noise_sum(q, result); });
}

// Along waves (1, 1, 0), (0, 1, 1), (1, 0, 1).
Oracle waves(std::size_t result) {
    return oracle([=](auto q) {
        using T = std::remove_cvref_t<decltype(q[0])>;
        const T two_pi = 2 * boost::math::constants::pi<T>();
        T sum = 0;
        for (std::size_t skipped : {2u, 0u, 1u}) {
            using std::floor;
            T turns = 0;
            for (std::size_t i = 0; i < 3; ++i)
                if (i != skipped) turns += q[i] - floor(q[i]);
            if (result == 3)
                sum += sin(two_pi * turns);
            else if (result != skipped)
                sum += two_pi * cos(two_pi * turns);
        }
        return T(sum / 3);
    });
}

Inputs places(std::size_t count, unsigned seed, double range) {
    return generate(count, 3, seed, [=](Random& random, std::span<float> q) {
        for (float& x : q) x = static_cast<float>(uniform(random, -range, range));
    });
}

Inputs lattice() {
    const Inputs axis =
        near(0, 2) + near(1, 2) + near(-3, 2) + only({0.5f, 0.25f, -0.0f, 65535.5f, 65536, -65536.25f, 131071.75f, 8388607.5f, 1e9f});
    return axis * axis * axis;
}

Inputs all_places(std::size_t count, unsigned seed) {
    return places(count / 2, seed, 10) + places(count / 2, seed + 100, 1e4) + lattice();
}

Row of_space(const char* function, const char* bound_of_value, double u_of_value, Oracle (*oracle_of)(std::size_t)) {
    Row row{function, "lib/noise.glsl", "q to 1e9, the lattice", function, 4, all_places, {}};
    row.claims.push_back({"value", bound_of_value, oracle_of(3), Bound::absolute(u_of_value * kU), component(3)});
    for (std::size_t i = 0; i < 3; ++i)
        row.claims.push_back(
            {fmt::format("derivative over {}", "xyz"[i]), "absolute 24 u", oracle_of(i), Bound::absolute(24 * kU), component(i)});
    return row;
}

Row sine_cosine_row() {
    const auto turn = [](bool sine) {
        return oracle([=](auto t) {
            using T = std::remove_cvref_t<decltype(t[0])>;
            using std::floor;
            const T angle = 2 * boost::math::constants::pi<T>() * (t[0] - floor(t[0]));
            return sine ? T(sin(angle)) : T(cos(angle));
        });
    };
    return {"sine_cosine",
            "lib/noise.glsl",
            "t to 1e30 turns",
            "sine_cosine",
            2,
            [](std::size_t count, unsigned seed) {
                const Inputs in =
                    generate(count, 1, seed, [](Random& random, std::span<float> t) { t[0] = static_cast<float>(uniform(random, -2, 2)); });
                return in + log_grid(1e-30, 1e30, 10000) + near(0.25f, 50) + near(0.5f, 50) + near(0.75f, 50) + near(-0.5f, 50) +
                       near(0, 50);
            },
            {{"sine", "absolute 4 u", turn(true), Bound::absolute(4 * kU), component(0)},
             {"cosine", "absolute 4 u", turn(false), Bound::absolute(4 * kU), component(1)}}};
}

double wave(double x) {
    return x - std::floor(x) < 0.5 ? 1 : -1;
}

// Mean over [x - w/2, x + w/2]: whole periods add nothing, what is left is cut at the multiples of 1/2.
double mean(double x, double w) {
    if (std::abs(2 * x - std::round(2 * x)) >= w) return wave(x); // no edge inside; sums would lose the digits of a small w
    const double from = x - std::floor(x) - std::fmod(w / 2, 1.0), to = from + std::fmod(w, 1.0); // shifted by whole periods
    double sum = 0;
    for (double at = from; at < to;) {
        const double next = std::min(to, std::floor(2 * at + 1) / 2);
        sum += (next - at) * wave((at + next) / 2);
        at = next;
    }
    return sum / w;
}

double checker(std::span<const float> in) {
    const auto width = [&](std::size_t i) { return std::abs(static_cast<double>(in[i])) + std::abs(static_cast<double>(in[i + 2])); };
    return 0.5 - 0.5 * mean(static_cast<double>(in[0]), width(2)) * mean(static_cast<double>(in[1]), width(3));
}

Inputs footprints(std::size_t count, unsigned seed) {
    return generate(count, 6, seed, [](Random& random, std::span<float> values) {
        const double range = log_uniform(random, 0.1, 1e6), width = log_uniform(random, 1e-9, 1e5);
        for (std::size_t i = 0; i < 6; ++i) values[i] = static_cast<float>(uniform(random, -1, 1) * (i < 2 ? range : width));
    });
}

} // namespace

Rows noise_rows() {
    return {of_space("gradient_noise", "absolute 8 u", 8, noise),
            of_space("waves", "absolute 5 u", 5, waves),
            sine_cosine_row(),
            {"checker",
             "lib/checker.glsl",
             "uv to 1e6, footprints of 1e-9 to 1e5",
             "checker",
             1,
             footprints,
             {{"", "absolute 8 u", {checker, checker}, Bound::absolute(8 * kU)}}}};
}

} // namespace lightbench::kernels
