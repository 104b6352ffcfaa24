// Decisions about the contrast of cells: AA-1.
#include "kernel_test.h"

namespace lightbench::kernels {

TEST_F(Kernel, ContrastExceeds) {
    expect_rows(device, "contrast_exceeds");
}

// Black cells, what is no number and what is infinite are not split.
TEST_F(Kernel, ContrastOfNoPicture) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const Inputs black = only({0.0f, -0.0f}) * only({0.0f, -0.0f}),
                 bad = only({kNaN}) * only({0, 1, kNaN, kInfinity}) + only({1}) * only({kNaN});
    const KernelRun run =
        run_kernel(device, "contrast_exceeds", (black + bad + only({kInfinity}) * only({0, 1, kInfinity})) * only({0.25f, 0}));
    expect_within(run, constant(0), Bound::exact());
}

} // namespace lightbench::kernels
