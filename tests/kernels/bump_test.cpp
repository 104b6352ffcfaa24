// Tilted normals and tangent frames against double: BM-2, BM-3.
#include "kernel_test.h"

#include <array>
#include <cmath>

namespace lightbench::kernels {

namespace {

using Vector = std::array<double, 3>;

Vector at(std::span<const float> values, std::size_t first) {
    return {static_cast<double>(values[first]), static_cast<double>(values[first + 1]), static_cast<double>(values[first + 2])};
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const Vector& v) {
    return std::hypot(v[0], v[1], v[2]);
}

Vector plus(const Vector& a, const Vector& b, double factor) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Vector unit(const Vector& v) {
    return plus({0, 0, 0}, v, 1 / length(v));
}

void put(std::span<float> out, const Vector& v) {
    for (std::size_t i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i]);
}

Vector random_unit(Random& random) {
    Vector v{};
    unit_vector(random, v);
    return v;
}

Measure off_unit(std::size_t first) {
    return [=](std::span<const float>, std::span<const float> out) { return length(at(out, first)) - 1; };
}

Inputs vec(float x, float y, float z) {
    return only({x}) * only({y}) * only({z});
}

// Some n, a t at any small angle from n or its opposite, of any length; both handednesses.
void fill_frame(Random& random, std::span<float> in) {
    const Vector n = random_unit(random);
    const double side = uniform(random, -1, 1) < 0 ? -1 : 1, along = uniform(random, -1, 1) < 0 ? side : 0;
    const Vector t = plus(plus({0, 0, 0}, n, along), random_unit(random), log_uniform(random, 1e-9, 1));
    put(in.subspan(0, 3), n);
    put(in.subspan(3, 3), plus({0, 0, 0}, t, log_uniform(random, 1e-20, 1e20)));
    in[6] = uniform(random, -1, 1) < 0 ? -1.0f : 1.0f;
}

void expect_frame(const KernelRun& run) {
    const auto product = [](auto a, auto b) {
        return [=](std::span<const float> in, std::span<const float> out) { return dot(a(in, out), b(in, out)); };
    };
    const auto n = [](std::span<const float> in, std::span<const float>) { return at(in, 0); };
    const auto tt = [](std::span<const float>, std::span<const float> out) { return at(out, 0); };
    const auto bb = [](std::span<const float>, std::span<const float> out) { return at(out, 3); };
    const Bound bound = Bound::absolute(4 * kU);
    expect_within(run, constant(0), bound, off_unit(0));
    expect_within(run, constant(0), bound, off_unit(3));
    expect_within(run, constant(0), bound, product(n, tt));
    expect_within(run, constant(0), bound, product(n, bb));
    expect_within(run, constant(0), bound, product(tt, bb));
    expect_within(run, constant(0), Bound::exact(), [](std::span<const float> in, std::span<const float> out) {
        const Vector a = at(in, 0), b = at(out, 0), c = at(out, 3);
        const double turn = c[0] * (a[1] * b[2] - a[2] * b[1]) + c[1] * (a[2] * b[0] - a[0] * b[2]) + c[2] * (a[0] * b[1] - a[1] * b[0]);
        return (turn < 0) == (in[6] < 0) ? 0 : 1;
    });
}

} // namespace

TEST_F(Kernel, PerturbNormal) {
    const auto along = [](std::span<const float> in) { return dot(unit(at(in, 0)), at(in, 3)); };
    const auto raised = [=](std::span<const float> in) {
        const Vector n = unit(at(in, 0));
        return plus(n, plus(at(in, 3), n, -along(in)), -1);
    };
    const Bound bound =
        Bound::function([=](std::span<const float> in, double) { return (8 + 4 * std::abs(along(in)) / length(raised(in))) * kU; });
    for (unsigned seed : seeds()) {
        const Inputs in = generate(kMillion, 6, seed, [](Random& random, std::span<float> values) {
            const Vector n = random_unit(random), any = random_unit(random);
            const Vector g = plus(any, n, -dot(n, any) * (uniform(random, -1, 1) < 0 ? 1 : 0));
            put(values.subspan(0, 3), n);
            put(values.subspan(3, 3), plus({0, 0, 0}, g, log_uniform(random, 1e-6, 1e4)));
        });
        const KernelRun run = run_kernel(device, "perturb_normal", in, 3);
        expect_within(run, constant(0), Bound::absolute(6 * kU), off_unit(0));
        expect_within(run, constant(0), bound, [=](std::span<const float> values, std::span<const float> out) {
            return length(plus(at(out, 0), unit(raised(values)), -1));
        });
    }
}

// BM-3: n is what a bump made of the geometric normal, which faces the viewer.
TEST_F(Kernel, KeepFacing) {
    for (unsigned seed : seeds()) {
        const Inputs in = generate(kMillion, 9, seed, [](Random& random, std::span<float> values) {
            const Vector g = random_unit(random), any = random_unit(random), other = random_unit(random);
            const Vector n = plus(plus(any, g, -dot(g, any)), g, log_uniform(random, 1e-3, 1e3));
            put(values.subspan(0, 3), unit(n));
            put(values.subspan(3, 3), g);
            put(values.subspan(6, 3), unit(plus(other, g, dot(g, other) < 0 ? -2 * dot(g, other) : 0)));
        });
        const KernelRun run = run_kernel(device, "keep_facing", in, 3);
        expect_within(run, constant(0), Bound::absolute(6 * kU), off_unit(0));
        expect_within(run, constant(0), Bound::absolute(4 * kU), [](std::span<const float> values, std::span<const float> out) {
            return std::min(0.0, dot(at(out, 0), at(values, 6)));
        });
        const Measure moved = [](std::span<const float> values, std::span<const float> out) {
            return length(plus(at(out, 0), at(values, 0), -1));
        };
        const Bound continuous = Bound::function([](std::span<const float> values, double) {
            const double c = -dot(at(values, 0), at(values, 6));
            return c < -4 * kU ? 0 : 2 * c + 16 * kU;
        });
        expect_within(run, constant(0), continuous, moved);
    }
}

TEST_F(Kernel, KeepFacingFallsBack) {
    const Inputs up = vec(0, 0, 1), down = vec(0, 0, -1), side = vec(1, 0, 0);
    const KernelRun run = run_kernel(device, "keep_facing", down * side * up + up * side * down, 3);
    EXPECT_EQ(run.results, (std::vector<float>{1, 0, 0, 1, 0, 0}));
}

TEST_F(Kernel, TangentFrame) {
    for (unsigned seed : seeds()) expect_frame(run_kernel(device, "tangent_frame", generate(kMillion, 7, seed, fill_frame), 6));
}

// BM-2: no area in uv, t along n, anything that a file may hold.
TEST_F(Kernel, TangentFrameOfAnything) {
    const Inputs normals = vec(0, 0, 1) + vec(0, 0, -1) + vec(1, 0, 0) + vec(0, -1, 0) + vec(0.6f, 0, 0.8f) + vec(-0.6f, 0, -0.8f);
    const Inputs special = special_values();
    const Inputs hands = only({1, -1});
    expect_frame(run_kernel(device, "tangent_frame", normals * (special * special * special) * hands, 6));
    expect_frame(run_kernel(device, "tangent_frame", normals * random_bits(kMillion / 8, 3, 1) * hands, 6));
    const Inputs units = generate(1000, 7, 1, fill_frame);
    Inputs parallel{7, {}};
    for (std::size_t i = 0; i < units.count(); ++i)
        for (float factor : {1.0f, -1.0f, 1e-30f, 3.0f, 0.0f}) {
            const std::span<const float> n = units[i].first(3);
            for (float x : {n[0], n[1], n[2], n[0] * factor, n[1] * factor, n[2] * factor, units[i][6]}) parallel.values.push_back(x);
        }
    expect_frame(run_kernel(device, "tangent_frame", parallel, 6));
}

// Where t is well away from n, the first axis is t less its part along n.
TEST_F(Kernel, TangentFrameKeepsTheDirection) {
    const Inputs in = generate(kMillion / 2, 7, 3, [](Random& random, std::span<float> values) {
        do fill_frame(random, values);
        while (std::abs(dot(at(values, 0), unit(at(values, 3)))) > 0.99);
    });
    expect_within(run_kernel(device, "tangent_frame", in, 6), constant(0), Bound::absolute(64 * kU),
                  [](std::span<const float> values, std::span<const float> out) {
                      const Vector n = unit(at(values, 0)), t = unit(at(values, 3));
                      return length(plus(at(out, 0), unit(plus(t, n, -dot(n, t))), -1));
                  });
}

// n less the gradient is the normal that the texel says: x along t, y along b, z along n.
TEST_F(Kernel, NormalMapGradient) {
    const Inputs in = generate(kMillion / 2, 10, 1, [](Random& random, std::span<float> values) {
        for (std::size_t i = 0; i < 3; ++i) values[i] = static_cast<float>(uniform(random, i == 2 ? 0.52 : 0, 1));
        put(values.subspan(3, 3), {1, 0, 0});
        put(values.subspan(6, 3), {0, 1, 0});
        values[9] = static_cast<float>(uniform(random, -2, 2));
    });
    const KernelRun run = run_kernel(device, "normal_map_gradient", in, 3);
    const auto slope = [](std::size_t i) {
        return oracle([=](auto values) { return -values[9] * (2 * values[i] - 1) / (2 * values[2] - 1); });
    };
    const Bound bound = Bound::function([](std::span<const float> values, double) {
        return 8 * kU / (2 * static_cast<double>(values[2]) - 1) / (2 * static_cast<double>(values[2]) - 1);
    });
    expect_within(run, slope(0), bound, component(0));
    expect_within(run, slope(1), bound, component(1));
    expect_within(run, constant(0), Bound::exact(), component(2));
}

// Level, backward and empty texels: slopes end at 128.
TEST_F(Kernel, NormalMapOfAnything) {
    const Inputs byte = grid(0, 1, 52);
    const KernelRun run = run_kernel(device, "normal_map_gradient", byte * byte * byte * vec(1, 0, 0) * vec(0, 1, 0) * only({1, 0}), 3);
    expect_within(run, constant(0), Bound::exact(), [](std::span<const float>, std::span<const float> out) {
        return std::abs(out[0]) <= 128.01f && std::abs(out[1]) <= 128.01f ? 0 : 1;
    });
}

} // namespace lightbench::kernels
