// Mirrored and refracted directions against Snell's law in double and 60 digits: RF-1, RF-2, RF-3, RT-3, EN-3.
#include "kernel_test.h"
#include "measure/numerics/lines.h"

#include <numbers>

namespace lightbench::kernels {

namespace {

double off_unit(std::span<const float>, std::span<const float> out) {
    return length(vec_of(out, 0)) - 1;
}

Inputs vec(float x, float y, float z) {
    return only({x}) * only({y}) * only({z});
}

} // namespace

TEST_F(Kernel, MirrorDirection) {
    expect_rows(device, "mirror_direction");
}

// RT-3.
TEST_F(Kernel, CornerCube) {
    const Inputs in = generate(kMillion / 8, 3, 1, [](Random& random, std::span<float> i) { put(i, 0, random_direction(random)); });
    expect_within(run_kernel(device, "corner_cube", in, 3), constant(0), Bound::absolute(1e-6),
                  [](std::span<const float> i, std::span<const float> out) { return length(vec_of(out, 0) + vec_of(i, 0)); });
}

// RF-3: unit after a thousand surfaces.
TEST_F(Kernel, DirectionsStayUnit) {
    const Inputs mirrors = generate(1u << 14, 12, 1, [](Random& random, std::span<float> values) {
        for (std::size_t i = 0; i < 12; i += 3) put(values, i, random_direction(random));
    });
    expect_within(run_kernel(device, "mirror_drift", mirrors, 3), constant(0), Bound::absolute(4 * kU), off_unit);
    const Inputs panes = generate(1u << 14, 7, 2, [](Random& random, std::span<float> values) {
        fill_incidence(random, values, uniform(random, 0, 1.5));
        values[6] = static_cast<float>(uniform(random, 1, 2.4));
    });
    const KernelRun run = run_kernel(device, "refracted_drift", panes, 3);
    expect_within(run, constant(0), Bound::absolute(4 * kU), off_unit);
}

// RF-1: from normal incidence to grazing, into dense and thin media and into all but the same one.
TEST_F(Kernel, RefractedDirection) {
    expect_rows(device, "refracted_direction");
}

// From air into glass at 30 degrees the ray bends by 10.53 degrees; straight in, not at all; eta = 1 gives i to the last bit.
TEST_F(Kernel, RefractedAnchors) {
    const KernelRun glass = run_kernel(device, "refracted_direction", vec(0.5f, 0, -0.8660254f) * vec(0, 0, 1) * only({1.5f}), 4);
    const double bent = 30 - std::asin(static_cast<double>(glass.result(0)[0])) * 180 / std::numbers::pi;
    EXPECT_NEAR(bent, 30 - std::asin(1.0 / 3) * 180 / std::numbers::pi, 1e-5);
    EXPECT_NEAR(bent, 10.53, 0.005);
    const KernelRun straight = run_kernel(device, "refracted_direction", vec(0, 0, -1) * vec(0, 0, 1) * only({0.5f, 1, 1.5f, 1e6f}), 4);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(straight.result(i)[2], -1.0f);
    const Inputs same = generate(kMillion / 16, 7, 1, [](Random& random, std::span<float> values) {
        fill_incidence(random, values, uniform(random, 0, 0.5 * std::numbers::pi));
        values[6] = 1;
    });
    expect_within(run_kernel(device, "refracted_direction", same + vec(1, 0, 0) * vec(0, 0, 1) * only({1}), 4), constant(0), Bound::exact(),
                  [](std::span<const float> in, std::span<const float> out) { return length(vec_of(out, 0) - vec_of(in, 0)); });
}

// RF-2: at the critical angle the answer is that of exact arithmetic. i = (s, 0, -c), n = z: the cosine is c itself.
TEST_F(Kernel, TotalReflection) {
    Inputs in{7, {}};
    for (float eta : {0.3f, 0.5f, 0.66666667f, 0.75f, 0.9f, 0.99f, 0.9999f, 0.99999994f}) {
        const double wide = static_cast<double>(eta);
        const float critical = static_cast<float>(std::sqrt((1 - wide) * (1 + wide)));
        for (float c : near(critical, 8).values) {
            const float s = static_cast<float>(std::sqrt((1 - static_cast<double>(c)) * (1 + static_cast<double>(c))));
            in.values.insert(in.values.end(), {s, 0, -c, 0, 0, 1, eta});
        }
    }
    const KernelRun run = run_kernel(device, "refracted_direction", in, 4);
    const auto passes = [](std::span<const float> values) {
        const Precise c = values[2], eta = values[6];
        return eta * eta + c * c > 1 ? 1.0 : 0.0;
    };
    expect_within(run, {passes, passes}, Bound::exact(), component(3));
    const Inputs beyond = generate(kMillion / 16, 7, 1, [](Random& random, std::span<float> values) {
        const double eta = uniform(random, 0.1, 0.99);
        fill_incidence(random, values, uniform(random, std::asin(eta) * 1.0001 + 1e-6, 0.5 * std::numbers::pi));
        values[6] = static_cast<float>(eta);
    });
    const KernelRun total = run_kernel(device, "refracted_direction", beyond, 4);
    expect_within(total, constant(0), Bound::exact(), component(3));
    expect_within(total, constant(0), Bound::exact(),
                  [](std::span<const float>, std::span<const float> out) { return length(vec_of(out, 0)); });
}

} // namespace lightbench::kernels
