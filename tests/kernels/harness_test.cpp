// The tests of the tests: what is wrong is reported, with the worst input in full.
#include "kernel_test.h"

#include "measure/numerics/findings.h"

#include <cstring>
#include <gmock/gmock.h>
#include <set>

namespace lightbench::kernels {

namespace {

const Oracle kRight = oracle([](auto in) { return 1 / (in[0] + in[1]); });
const Oracle kWrong = oracle([](auto in) { return 1 / (in[0] + in[1] * 1.000001); });

Inputs small_grid() {
    return log_grid(1e-3, 1e3, 100) * log_grid(1e-3, 1e3, 100);
}

using testing::HasSubstr;

} // namespace

TEST_F(Kernel, WrongOracleIsReported) {
    const KernelRun run = run_kernel(device, "attenuation_linear", small_grid());
    EXPECT_TRUE(judge(run, kRight, Bound::relative(4 * kU)).holds);
    const Verdict verdict = judge(run, kWrong, Bound::relative(4 * kU));
    EXPECT_FALSE(verdict.holds);
    EXPECT_THAT(verdict.message, HasSubstr("outside the bound; worst at (0x1."));
    EXPECT_THAT(verdict.message, HasSubstr("expected 0x1."));
}

// An oracle whose double is worse than the bound needs is not believed, even where it agrees with the kernel.
TEST_F(Kernel, SloppyOracleIsReported) {
    const KernelRun run = run_kernel(device, "attenuation_linear", small_grid());
    const Oracle sloppy{[](std::span<const float> in) { return static_cast<double>(1 / (in[0] + in[1])); }, kRight.in_60_digits};
    const Verdict verdict = judge(run, sloppy, Bound::relative(4 * kU));
    EXPECT_FALSE(verdict.holds);
    EXPECT_THAT(verdict.message, HasSubstr("not good enough"));
}

TEST_F(Kernel, MissingInvocationIsReported) {
    const Oracle same = oracle([](auto in) { return in[0]; });
    EXPECT_TRUE(judge(run_kernel(device, "forgetful", grid(1, 2, 1000)), same, Bound::exact()).holds);
    const Verdict verdict = judge(run_kernel(device, "forgetful", grid(1, 2, 1000) + only({-3})), same, Bound::exact());
    EXPECT_FALSE(verdict.holds);
    EXPECT_THAT(verdict.message, HasSubstr("1 of 1001 invocations did not finish, the first at (-0x1.8p+1)"));
}

// The table of the program: a bound that is too small, or an oracle that is wrong, is a violated row.
TEST_F(Kernel, WrongRowIsReported) {
    Row row = row_of("attenuation_linear");
    EXPECT_TRUE(run_rows(device, {row}, kQuickInputs).at(0).verdict.holds);
    row.claims = {{"bound too small", "relative u/8", row.claims[0].oracle, Bound::relative(kU / 8)},
                  {"wrong oracle", "relative 4 u", kWrong, Bound::relative(4 * kU)}};
    for (const Finding& finding : run_rows(device, {row}, kQuickInputs)) {
        EXPECT_FALSE(finding.verdict.holds) << finding.what;
        EXPECT_GT(finding.verdict.share, 1) << finding.what;
        EXPECT_GT(finding.verdict.outside, 0u);
        EXPECT_EQ(finding.verdict.where.size(), 2u);
    }
}

// Every function has its rows once: no two of the same domain, none without a claim.
TEST(Rows, AreOneADomain) {
    std::set<std::string> seen;
    for (const Row& row : all_rows()) {
        EXPECT_TRUE(seen.insert(row.function + " over " + row.domain).second) << row.function;
        EXPECT_FALSE(row.claims.empty()) << row.function;
        EXPECT_EQ(find_kernel(row.kernel).name, row.kernel + ".comp");
        const std::vector<float> once = row.inputs(4096, 1).values, again = row.inputs(4096, 1).values;
        ASSERT_EQ(once.size(), again.size());
        EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(float)), 0) << "the same seed gives the same numbers";
    }
}

// Tuples of another length than the kernel reads would be judged by the wrong numbers.
TEST_F(Kernel, WrongArityIsReported) {
    const KernelRun run = run_kernel(device, "forgetful", small_grid());
    EXPECT_EQ(run.missing, run.inputs.count());
}

// NaN where a number is expected, a number where NaN is expected, the other infinity: never within any bound.
TEST_F(Kernel, NonFiniteResultsAreReported) {
    const KernelRun run = run_kernel(device, "forgetful", grid(1, 2, 10));
    const auto verdict = [&](double expected, double got) {
        const Oracle constant{[=](std::span<const float>) { return expected; }, [=](std::span<const float>) { return expected; }};
        return judge(run, constant, Bound::absolute(1e300), [=](std::span<const float>, std::span<const float>) { return got; }).holds;
    };
    const double nan = static_cast<double>(kNaN), infinity = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(verdict(nan, nan) && verdict(infinity, infinity) && verdict(1, 2));
    EXPECT_FALSE(verdict(1, nan) || verdict(nan, 1) || verdict(infinity, -infinity) || verdict(infinity, 1) || verdict(1, infinity));
}

TEST_F(Kernel, NoInputsIsReported) {
    EXPECT_FALSE(judge(run_kernel(device, "forgetful", Inputs{1, {}}), kRight, Bound::exact()).holds);
}

} // namespace lightbench::kernels
