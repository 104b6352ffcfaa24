// Sums rounded upwards against the processor's own.
#include "kernel_test.h"

#include <cfenv>

namespace lightbench::kernels {

namespace {

// volatile: the addition happens while the mode is set, at run time.
double sum_of(std::span<const float> in) {
    const volatile float x = in[0], y = in[1];
    std::fesetround(FE_UPWARD);
    const volatile float sum = x + y;
    std::fesetround(FE_TONEAREST);
    return static_cast<double>(sum);
}

float with_sign(Random& random, double magnitude) {
    return static_cast<float>(random() % 2 ? magnitude : -magnitude);
}

} // namespace

TEST_F(Kernel, SumUpwards) {
    const Oracle upwards{sum_of, sum_of};
    for (unsigned seed : seeds()) {
        const Inputs any = generate(kMillion, 2, seed, [](Random& random, std::span<float> in) {
            in[0] = with_sign(random, log_uniform(random, 1e-9, 1e9));
            in[1] = with_sign(random, std::abs(static_cast<double>(in[0])) * log_uniform(random, 1e-9, 1e9));
        });
        expect_within(run_kernel(device, "sum_upwards", any), upwards, Bound::exact());
    }
    const Inputs steps =
        near(1, 4) + near(-1, 4) + near(2, 4) + near(-0.5f, 4) + only({0, 0x1p-24f, -0x1p-24f, 0x1p-25f, -0x1p-25f, 1e-30f});
    expect_within(run_kernel(device, "sum_upwards", steps * steps), upwards, Bound::exact());
}

} // namespace lightbench::kernels
