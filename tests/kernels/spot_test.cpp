// The edge of spots against its formula.
#include "kernel_test.h"

namespace lightbench::kernels {

TEST_F(Kernel, SpotFalloff) {
    expect_rows(device, "spot_falloff");
}

TEST_F(Kernel, SpotIsExactOutsideItsEdge) {
    const Inputs in =
        grid(-1, 0.5, 1000) * only({0.5f}) * only({0.5f, 0.75f, 1}) + grid(0.75, 1, 1000) * only({-1, 0.5f, 0.75f}) * only({0.75f});
    expect_within(run_kernel(device, "spot_falloff", in), row_of("spot_falloff").claims[0].oracle, Bound::exact());
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
