// The edge of spots against its formula.
#include "kernel_test.h"

namespace lightbench::kernels {

namespace {

// (cos_angle, cos_outer, cos_inner)
const Oracle kFalloff = oracle([](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    if (in[0] >= in[2]) return T(1);
    if (in[0] <= in[1]) return T(0);
    const T t = (in[0] - in[1]) / (in[2] - in[1]);
    return T(t * t * (3 - 2 * t));
});

// Cones of any width, angles about and inside their edges.
Inputs cones(unsigned seed) {
    return generate(kMillion, 3, seed, [](Random& random, std::span<float> in) {
        in[1] = static_cast<float>(uniform(random, -1, 1));
        in[2] = static_cast<float>(uniform(random, static_cast<double>(in[1]), 1));
        const double width = static_cast<double>(in[2]) - static_cast<double>(in[1]);
        in[0] = static_cast<float>(static_cast<double>(in[1]) + uniform(random, -0.2, 1.2) * width);
    });
}

} // namespace

TEST_F(Kernel, SpotFalloff) {
    for (unsigned seed : seeds()) {
        const Inputs narrow = near(0.999f, 50) * only({0.999f}) * near(0.99901f, 50); // edges of a few ulp
        expect_within(run_kernel(device, "spot_falloff", cones(seed) + narrow), kFalloff, Bound::absolute(8 * kU));
    }
}

TEST_F(Kernel, SpotIsExactOutsideItsEdge) {
    const Inputs in =
        grid(-1, 0.5, 1000) * only({0.5f}) * only({0.5f, 0.75f, 1}) + grid(0.75, 1, 1000) * only({-1, 0.5f, 0.75f}) * only({0.75f});
    expect_within(run_kernel(device, "spot_falloff", in), kFalloff, Bound::exact());
}

// inner == outer: lit from the edge on, dark one ulp outside.
TEST_F(Kernel, SpotWithHardEdge) {
    for (float edge : {-1.0f, -0.5f, 1e-30f, 0.8660254f, 1.0f}) {
        const Inputs in = (near(edge, 5) + grid(-1, 1, 101)) * only({edge}) * only({edge});
        const KernelRun run = run_kernel(device, "spot_falloff", in);
        expect_within(run, oracle([](auto x) { return decltype(x[0] + x[0])(x[0] >= x[1] ? 1 : 0); }), Bound::exact());
    }
}

TEST_F(Kernel, SpotKeepsNaN) {
    const Inputs in = only({kNaN}) * only({0.5f}) * only({0.5f, 0.75f});
    expect_within(run_kernel(device, "spot_falloff", in), constant(static_cast<double>(kNaN)), Bound::exact());
}

} // namespace lightbench::kernels
