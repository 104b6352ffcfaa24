// Mappings of space to texture coordinates against arc tangents in double: TX-3, TX-4, TX-5.
#include "kernel_test.h"

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
Inputs points(unsigned seed) {
    const Inputs box = generate(kMillion, 3, seed, [](Random& random, std::span<float> p) {
        for (float& x : p) x = static_cast<float>(uniform(random, -1, 1));
    });
    const Inputs axis = generate(kMillion / 4, 3, seed + 100, [](Random& random, std::span<float> p) {
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

} // namespace

TEST_F(Kernel, Turns) {
    const Measure off = [](std::span<const float> in, std::span<const float> out) {
        if (!(out[0] >= 0 && out[0] < 1)) return 2.0;
        const double y = static_cast<double>(in[0]), x = static_cast<double>(in[1]), low = std::min(std::abs(y), std::abs(x));
        const double flushed = low < 0x1p-126 ? low / (2 * kPi * std::max(std::abs(y), std::abs(x))) : 0; // it may count as 0
        const double missed = around(static_cast<double>(out[0]) - azimuth(y, x));
        return low > 0 ? std::max(0.0, missed - flushed) : missed;
    };
    for (unsigned seed : seeds()) {
        const Inputs in = generate(kMillion, 2, seed, [](Random& random, std::span<float> yx) {
            const double angle = uniform(random, 0, 2 * kPi), length = log_uniform(random, 1e-30, 1e37),
                         away = log_uniform(random, 1e-9, 1);
            yx[0] = static_cast<float>(length * std::sin(angle) * away);
            yx[1] = static_cast<float>(length * std::cos(angle));
        });
        const Inputs axis = near(1, 100) + near(-1, 100) + near(0.41421356f, 100) + only({0.0f, -0.0f, 1e-37f, -1e-37f, 1e38f});
        expect_within(run_kernel(device, "turns", in + axis * axis), constant(0), Bound::absolute(1.5 * kU), off);
    }
}

TEST_F(Kernel, MapSpherical) {
    for (unsigned seed : seeds()) {
        const KernelRun run = run_kernel(device, "mapping", points(seed), 6);
        expect_within(run, constant(0), Bound::absolute(1.5 * kU), off_azimuth(0));
        expect_within(run, constant(0), Bound::absolute(4 * kU), [](std::span<const float> p, std::span<const float> out) {
            const bool middle = p[0] == 0 && p[1] == 0 && p[2] == 0;
            return static_cast<double>(out[1]) - (middle ? 1 : polar_v(p));
        });
    }
}

TEST_F(Kernel, MapCylindrical) {
    const KernelRun run = run_kernel(device, "mapping", points(1), 6);
    expect_within(run, constant(0), Bound::absolute(1.5 * kU), off_azimuth(2));
    expect_within(run, oracle([](auto p) { return p[2] / 2 + 0.5; }), Bound::absolute(2 * kU), component(3));
}

TEST_F(Kernel, MapPlanar) {
    const KernelRun run = run_kernel(device, "mapping", points(1), 6);
    expect_within(run, oracle([](auto p) { return p[0] / 2 + 0.5; }), Bound::absolute(2 * kU), component(4));
    expect_within(run, oracle([](auto p) { return p[1] / 2 + 0.5; }), Bound::absolute(2 * kU), component(5));
}

// TX-3: on the axis u is 0; upwards v is 1, downwards 0.
TEST_F(Kernel, PolesAreDefined) {
    const Inputs zeros = only({0.0f, -0.0f});
    const KernelRun run = run_kernel(device, "mapping", zeros * zeros * only({1, 1e-10f, -1, -1e-10f}), 6);
    expect_within(run, oracle([](auto p) { return p[2] > 0 ? 1 : 0; }), Bound::exact(), component(1));
    expect_within(run, constant(0), Bound::exact(), component(0));
}

TEST_F(Kernel, MapGradients) {
    const auto u = [](std::array<double, 3> p) { return azimuth(p[1], p[0]); };
    const auto v = [](std::array<double, 3> p) { return 1 - std::atan2(std::hypot(p[0], p[1]), p[2]) / kPi; };
    for (unsigned seed : seeds()) {
        const Inputs in = generate(kMillion / 4, 3, seed, [](Random& random, std::span<float> p) {
            double d[3];
            do unit_vector(random, d);
            while (std::hypot(d[0], d[1]) < 1e-3);
            const double length = log_uniform(random, 1e-6, 1e3);
            for (std::size_t i = 0; i < 3; ++i) p[i] = static_cast<float>(d[i] * length);
        });
        const KernelRun run = run_kernel(device, "mapping_gradients", in, 18);
        expect_within(run, constant(0), Bound::absolute(8 * kU), off_gradient(u, 0));
        expect_within(run, constant(0), Bound::absolute(8 * kU), off_gradient(v, 3));
        expect_within(run, constant(0), Bound::absolute(8 * kU), off_gradient(u, 6));
        for (const auto& [i, value] :
             {std::pair{9u, 0.0}, {10u, 0.0}, {11u, 0.5}, {12u, 0.5}, {13u, 0.0}, {14u, 0.0}, {15u, 0.0}, {16u, 0.5}})
            expect_within(run, constant(value), Bound::exact(), component(i));
    }
}

// Nearer to the axis than a float can tell, gradients stay below 2^23 over the distance from the middle.
TEST_F(Kernel, MapGradientsAtThePoles) {
    const Inputs little = only({0.0f, -0.0f, 1e-45f, 1e-38f, -1e-30f, 1e-12f, 1e-8f, -1e-7f});
    const KernelRun run = run_kernel(device, "mapping_gradients", little * little * only({1, -1, 0.5f, 0, 1e-20f}), 18);
    const Measure largest = [](std::span<const float> p, std::span<const float> out) {
        double most = 0;
        for (float x : out) most = std::isfinite(x) ? std::max(most, std::abs(static_cast<double>(x))) : 1e30;
        return std::max(0.0, most * std::max(static_cast<double>(std::abs(p[2])), 0x1p-30) / 0x1p23 - 1);
    };
    expect_within(run, constant(0), Bound::exact(), largest);
}

TEST_F(Kernel, WrappedDerivatives) {
    const Inputs in = (grid(-1, 1, 4097) + near(0.5f, 10) + near(-0.5f, 10) + near(0, 10)) * only({0, 0.75f, -3});
    const KernelRun run = run_kernel(device, "wrapped", in, 2);
    expect_within(run, oracle([](auto d) { return d[1]; }), Bound::exact(), component(1));
    const Measure shorter = [](std::span<const float> d, std::span<const float> out) {
        const double whole = static_cast<double>(d[0]) - static_cast<double>(out[0]);
        const double flushed = std::abs(d[0]) < 0x1p-126f ? 0x1p-126 : 0; // denormals count as 0 on some devices
        return std::abs(out[0]) <= 0.5f && std::abs(whole - std::round(whole)) <= flushed ? 0 : 1;
    };
    expect_within(run, constant(0), Bound::exact(), shorter);
}

} // namespace lightbench::kernels
