// Logarithms, exponentials and powers near 1 against double and 60 digits: LI-1's stable form.
#include "kernel_test.h"

namespace lightbench::kernels {

TEST_F(Kernel, LogOneMinus) {
    expect_rows(device, "log_one_minus");
}

TEST_F(Kernel, LogUnit) {
    expect_rows(device, "log_unit");
}

TEST_F(Kernel, ExpNegative) {
    expect_rows(device, "exp_negative");
}

TEST_F(Kernel, PowerOneMinus) {
    expect_rows(device, "power_one_minus");
}

TEST_F(Kernel, PowersKeepNaN) {
    const Oracle nan = constant(static_cast<double>(kNaN));
    for (const char* kernel : {"log_one_minus", "exp_negative"})
        expect_within(run_kernel(device, kernel, only({kNaN})), nan, Bound::exact());
    const Inputs in = only({kNaN}) * only({0, 1, 1000, 1e30f}) + only({0.001f}) * only({kNaN});
    expect_within(run_kernel(device, "power_one_minus", in), nan, Bound::exact());
}

// pow() is what the bound was made against: if it passed, the bound would prove nothing.
TEST_F(Kernel, NaivePowerIsReported) {
    const Inputs in = log_grid(1e-6, 0.01, 1000) * log_grid(1, 1000, 100);
    const Verdict verdict = judge(run_kernel(device, "naive_power", in), row_of("power_one_minus").claims[0]);
    EXPECT_FALSE(verdict.holds);
    EXPECT_NE(verdict.message.find("outside the bound; worst at (0x1."), std::string::npos) << verdict.message;
}

} // namespace lightbench::kernels
