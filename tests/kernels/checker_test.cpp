// The filtered checkerboard against sums over the pieces of the square wave, in double.
#include "kernel_test.h"

namespace lightbench::kernels {

TEST_F(Kernel, Checker) {
    expect_rows(device, "checker");
}

TEST_F(Kernel, CheckerUnfiltered) {
    const Inputs axis = grid(-3, 3, 601) + near(0.5f, 3) + near(0, 1) + near(1, 3) + only({1e9f, -1e9f, 3e38f});
    std::vector<float> values;
    for (float x : axis.values)
        if (!(x < 0 && x > -1e-7f)) values.push_back(x); // whose fraction is 1 in float: either side is right
    const Inputs places{1, values};
    expect_within(run_kernel(device, "checker", places * places * only({0}) * only({0.0f}) * only({0}) * only({-0.0f})),
                  row_of("checker").claims[0].oracle, Bound::exact());
}

// Huge and broken footprints are grey: a finite number, whatever comes.
TEST_F(Kernel, CheckerOfHugeFootprints) {
    const Inputs axis = only({0, 0.3f, -7.7f, 1e9f}), wide = only({1e7f, 1e30f, kFloatMax, std::numeric_limits<float>::infinity(), kNaN});
    expect_within(run_kernel(device, "checker", axis * axis * wide * wide * wide * wide), constant(0.5), Bound::absolute(1e-12));
}

} // namespace lightbench::kernels
