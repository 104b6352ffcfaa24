// Compares what a kernel computed with its oracle. In: a run, an oracle, a bound. Out: a verdict that names the worst input.
#pragma once

#include "oracle.h"
#include "run_kernel.h"

#include <string>

namespace lightbench::kernels {

// The number of a result that the oracle speaks of: by default its first float.
using Measure = std::function<double(std::span<const float> in, std::span<const float> out)>;
double first_float(std::span<const float> in, std::span<const float> out);

struct Verdict {
    bool holds = false;
    std::string message; // failure: worst input in hexadecimal, expected, got; success: the worst share of the bound
};

// Non-finite expectations must be met as such: NaN by NaN, an infinity by the same one.
Verdict judge(const KernelRun& run, const Oracle& oracle, const Bound& bound, const Measure& measure = first_float);

// Fails the test if the verdict does; prints it either way, for the record of what was reached.
void expect_within(const KernelRun& run, const Oracle& oracle, const Bound& bound, const Measure& measure = first_float);

} // namespace lightbench::kernels
