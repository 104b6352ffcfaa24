// Judging every result in double, a sample of the oracle in 60 digits.
#include "measure/numerics/verdict.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace lightbench::kernels {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kSample = 1000; // tuples for the 60-digit form: seconds at most

// Error as a share of what is allowed; above 1 fails.
double share(double got, double expected, double allowed) {
    if (std::isnan(expected)) return std::isnan(got) ? 0 : kInfinity;
    if (std::isinf(expected) || got == expected) return got == expected ? 0 : kInfinity;
    const double error = std::abs(got - expected);
    return std::isnan(error) || allowed == 0 ? kInfinity : error / allowed;
}

std::string hex_tuple(std::span<const float> tuple) {
    std::string text;
    for (float x : tuple) text += fmt::format("{}{:a}", text.empty() ? "(" : ", ", x);
    return text + ")";
}

struct Worst {
    std::size_t index = 0, outside = 0;
    double share = -1;
};

Worst find_worst(const KernelRun& run, const Oracle& oracle, const Bound& bound, const Measure& measure) {
    Worst worst;
    for (std::size_t i = 0; i < run.inputs.count(); ++i) {
        const std::span<const float> in = run.inputs[i];
        const double expected = oracle.in_double(in);
        const double s = share(measure(in, run.result(i)), expected, bound.allowed(in, expected));
        worst.outside += s > 1;
        if (s > worst.share) worst = {i, worst.outside, s};
    }
    return worst;
}

std::string describe(const KernelRun& run, const Oracle& oracle, const Bound& bound, const Measure& measure, const Worst& worst) {
    const std::span<const float> in = run.inputs[worst.index];
    const double expected = oracle.in_60_digits(in), got = measure(in, run.result(worst.index));
    return fmt::format("worst at {}: expected {:a} ({:.9g}), got {:a} ({:.9g}), off by {:.3g}, {:.3g} of the bound", hex_tuple(in),
                       expected, expected, got, got, std::abs(got - expected), share(got, expected, bound.allowed(in, expected)));
}

// Where double and 60 digits differ by more than a thousandth of the bound, the oracle itself is not to be trusted.
std::string doubt(const KernelRun& run, const Oracle& oracle, const Bound& bound) {
    const std::size_t step = std::max<std::size_t>(1, run.inputs.count() / kSample);
    for (std::size_t i = 0; i < run.inputs.count(); i += step) {
        const std::span<const float> in = run.inputs[i];
        const double fast = oracle.in_double(in), slow = oracle.in_60_digits(in);
        const double margin = std::max(bound.allowed(in, slow) / 1000, 4 * std::numeric_limits<double>::denorm_min());
        if (share(fast, slow, margin) > 1)
            return fmt::format("the oracle in double is not good enough at {}: {:a}, in 60 digits {:a}", hex_tuple(in), fast, slow);
    }
    return {};
}

} // namespace

double first_float(std::span<const float>, std::span<const float> out) {
    return static_cast<double>(out[0]);
}

Measure component(std::size_t i) {
    return [=](std::span<const float>, std::span<const float> out) { return static_cast<double>(out[i]); };
}

Bound Bound::ulp(double n) {
    return function([=](std::span<const float>, double expected) {
        const float x = static_cast<float>(std::abs(expected));
        return n * static_cast<double>(std::nextafter(x, std::numeric_limits<float>::infinity()) - x);
    });
}

Verdict judge(const KernelRun& run, const Oracle& oracle, const Bound& bound, const Measure& measure) {
    if (run.inputs.count() == 0) return {.message = fmt::format("{}: no inputs", run.kernel)};
    if (run.missing > 0)
        return {.message = fmt::format("{}: {} of {} invocations did not finish, the first at {}", run.kernel, run.missing,
                                       run.inputs.count(), hex_tuple(run.inputs[run.first_missing]))};
    if (const std::string d = doubt(run, oracle, bound); !d.empty()) return {.message = fmt::format("{}: {}", run.kernel, d)};
    const Worst worst = find_worst(run, oracle, bound, measure);
    const std::span<const float> in = run.inputs[worst.index];
    const double got = measure(in, run.result(worst.index)), expected = oracle.in_60_digits(in);
    Verdict verdict{worst.outside == 0, {}, true, worst.share, worst.share == 0 ? 0 : std::abs(got - expected), worst.outside, {}};
    verdict.where.assign(in.begin(), in.end());
    verdict.message = worst.share == 0 ? fmt::format("{}: {} inputs, every one exact", run.kernel, run.inputs.count())
                                       : fmt::format("{}: {} of {} inputs outside the bound; {}", run.kernel, worst.outside,
                                                     run.inputs.count(), describe(run, oracle, bound, measure, worst));
    return verdict;
}

} // namespace lightbench::kernels
