// Gradient noise, waves and the checkerboard against their definitions in double and 60 digits.
#include "kernel_test.h"

#include <array>
#include <cmath>
#include <numbers>

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

Inputs places(unsigned seed, double range) {
    return generate(kMillion / 2, 3, seed, [=](Random& random, std::span<float> q) {
        for (float& x : q) x = static_cast<float>(uniform(random, -range, range));
    });
}

Inputs lattice() {
    const Inputs axis =
        near(0, 2) + near(1, 2) + near(-3, 2) + only({0.5f, 0.25f, -0.0f, 65535.5f, 65536, -65536.25f, 131071.75f, 8388607.5f, 1e9f});
    return axis * axis * axis;
}

} // namespace

TEST_F(Kernel, GradientNoise) {
    for (unsigned seed : seeds()) {
        const KernelRun run = run_kernel(device, "gradient_noise", places(seed, 10) + places(seed + 100, 1e4) + lattice(), 4);
        expect_within(run, noise(3), Bound::absolute(8 * kU), component(3));
        for (std::size_t i = 0; i < 3; ++i) expect_within(run, noise(i), Bound::absolute(24 * kU), component(i));
    }
}

// The largest value that any choice of gradients allows: at every place each corner's plane is at most the sum of its two larger distances.
TEST_F(Kernel, GradientNoiseIsInRange) {
    constexpr int kSteps = 100;
    double most = 0;
    for (int n = 0; n <= kSteps * kSteps * kSteps; ++n) {
        const std::array<double, 3> f{n % kSteps / 1.0 / kSteps, n / kSteps % kSteps / 1.0 / kSteps, n / kSteps / kSteps / 1.0 / kSteps};
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            double whole = 1, all = 0, least = 1;
            for (std::size_t i = 0; i < 3; ++i) {
                const int upper = corner >> i & 1;
                whole *= weight(f[i], upper != 0)[0];
                all += std::abs(f[i] - upper);
                least = std::min(least, std::abs(f[i] - upper));
            }
            sum += whole * (all - least);
        }
        most = std::max(most, sum);
    }
    EXPECT_NEAR(most, 1.03623, 1e-4);
    EXPECT_LT(most * 0.96, 1);
    const Measure beyond = [](std::span<const float>, std::span<const float> out) {
        return std::max(0.0, std::abs(static_cast<double>(out[3])) - 1);
    };
    expect_within(run_kernel(device, "gradient_noise", places(7, 1000), 4), constant(0), Bound::exact(), beyond);
}

TEST_F(Kernel, SineCosine) {
    const auto turn = [](bool sine) {
        return oracle([=](auto t) {
            using T = std::remove_cvref_t<decltype(t[0])>;
            using std::floor;
            const T angle = 2 * boost::math::constants::pi<T>() * (t[0] - floor(t[0]));
            return sine ? T(sin(angle)) : T(cos(angle));
        });
    };
    for (unsigned seed : seeds()) {
        Inputs in =
            generate(kMillion, 1, seed, [](Random& random, std::span<float> t) { t[0] = static_cast<float>(uniform(random, -2, 2)); });
        in = in + log_grid(1e-30, 1e30, 10000) + near(0.25f, 50) + near(0.5f, 50) + near(0.75f, 50) + near(-0.5f, 50) + near(0, 50);
        const KernelRun run = run_kernel(device, "sine_cosine", in, 2);
        expect_within(run, turn(true), Bound::absolute(4 * kU), component(0));
        expect_within(run, turn(false), Bound::absolute(4 * kU), component(1));
    }
}

TEST_F(Kernel, Waves) {
    for (unsigned seed : seeds()) {
        const KernelRun run = run_kernel(device, "waves", places(seed, 10) + places(seed + 100, 1e4) + lattice(), 4);
        expect_within(run, waves(3), Bound::absolute(5 * kU), component(3));
        for (std::size_t i = 0; i < 3; ++i) expect_within(run, waves(i), Bound::absolute(24 * kU), component(i));
    }
}

} // namespace lightbench::kernels
