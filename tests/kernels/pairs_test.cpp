// The teaching pairs: the stable form is within reason everywhere, the naive one visibly is not, and wrong results are seen.
#include "kernel_test.h"

#include "gpu/float64.h"
#include "measure/function_curves.h"

#include <algorithm>

namespace lightbench::kernels {

namespace {

const PairLimits kFew{1u << 13, 1u << 10, 0.1, {.most = 6, .milliseconds = 300}};

Pair pair_named(const std::string& name) {
    for (const Pair& pair : all_pairs())
        if (pair.name == name) return pair;
    throw std::runtime_error(name);
}

} // namespace

TEST_F(Kernel, PairsShowWhatStabilityGains) {
    for (const Pair& pair : all_pairs()) {
        const PairFinding finding = measure_pair(device, pair, kFew);
        ASSERT_EQ(finding.forms.size(), 3u);
        EXPECT_GT(finding.inputs, kFew.inputs / 20) << pair.name;
        const FormErrors &stable = finding.forms[0].errors, &naive = finding.forms[1].errors;
        EXPECT_LE(stable.relative, 1e-3) << pair.name;
        EXPECT_LE(stable.wrong, pair.distance ? 0.1 : 0) << pair.name; // of decisions, those nearer than 3 u to their threshold
        if (!pair.distance) {
            EXPECT_GT(naive.relative + naive.wrong, 4 * stable.relative) << pair.name;
        }
        fmt::print("{}: {} inputs\n", pair.name, finding.inputs);
        for (const Form& form : finding.forms)
            fmt::print("  {}: relative {:.3g}, ulp {:.3g}, wrong {:.3g}; {:.3g} ns {}\n", form.name, form.errors.relative, form.errors.ulp,
                       form.errors.wrong, form.cost.median, form.lacking);
        EXPECT_EQ(finding.forms[2].lacking.empty(), gpu::has_float64(device) && pair.no_float64.empty()) << pair.name;
    }
}

TEST_F(Kernel, WrongResultsOfAPairAreReported) {
    const Pair pair = pair_named("inverse square");
    const Inputs in = only({1, 2, 4, 8});
    std::vector<float> results;
    for (std::size_t i = 0; i < 4; ++i) results.push_back(static_cast<float>(pair.expected(in[i])));
    EXPECT_LT(errors_of(pair, in, results).relative, 2 * kU);
    EXPECT_EQ(errors_of(pair, in, results).wrong, 0);
    results[1] *= 1.01f;
    EXPECT_NEAR(errors_of(pair, in, results).relative, 0.01, 1e-6);
    results[2] = kNaN;
    EXPECT_EQ(errors_of(pair, in, results).wrong, 0.25);
}

// A form that is mostly not finite would stand on the front with the worst of what is left.
TEST_F(Kernel, WrongFormsAreNotOnTheFront) {
    PairFinding finding{pair_named("linear"), 100, {}};
    finding.forms = {{"stable", {}, {1e-7, 1, 0}, {2, 1.9, 2.1, 9, true}}, {"naive", {}, {1e-9, 0.1, 0.9}, {1, 0.9, 1.1, 9, true}}};
    CostCurve curve = curve_of(finding);
    EXPECT_TRUE(std::isinf(curve.points[1].errors.at("relative")) && std::isinf(curve.points[1].errors.at("ulp")));
    EXPECT_TRUE(curve.points[0].pareto.contains("relative") && !curve.points[1].pareto.contains("relative"));
    EXPECT_THAT(curve.points[1].note, ::testing::HasSubstr("90 % of the results are not finite, or wrong altogether"));
    finding.pair = pair_named("contrast");
    curve = curve_of(finding);
    EXPECT_FALSE(curve.points[0].errors.contains("ulp"));
    EXPECT_EQ(curve.points[1].errors.at("relative"), 1e-9); // of decisions it is the wrong ones that are measured
}

// As fast as the loop around it: no time, and no place on the front.
TEST_F(Kernel, TimesLostInNoiseAreNone) {
    constexpr double kLost = std::numeric_limits<double>::quiet_NaN();
    const PairFinding finding{pair_named("linear"), 100, {{"stable", {}, {1e-9, 0, 0}, {kLost, kLost, kLost, 9, false}}}};
    const CostCurve curve = curve_of(finding);
    EXPECT_TRUE(curve.points[0].pareto.empty());
    EXPECT_THAT(curve.points[0].note, ::testing::HasSubstr("lost in the noise"));
    EXPECT_TRUE(curve.notes.empty());
}

TEST_F(Kernel, PairsAreCurvesOfAReport) {
    const CostCurve curve = curve_of(measure_pair(device, pair_named("linear"), kFew));
    EXPECT_EQ(curve.knob, "linear formula");
    EXPECT_EQ(curve.points.size(), gpu::has_float64(device) ? 3u : 2u);
    const auto& notes = curve.notes; // of times, too: so few runs tell little
    const bool lacking = std::ranges::any_of(notes, [](const std::string& note) { return note.starts_with("no "); });
    EXPECT_EQ(lacking, !gpu::has_float64(device)) << "the form in float64 is a point, or a note says why not";
    EXPECT_EQ(curve.points[0].value, "stable");
    EXPECT_TRUE(curve.points[1].errors.contains("relative") && curve.points[1].errors.contains("wrong"));
    EXPECT_GT(curve.points[1].runs, 0u);
}

} // namespace lightbench::kernels
