// Compares what a kernel computed with its oracle. In: a run, an oracle, a bound. Out: a verdict that names the worst input.
#pragma once

#include "measure/numerics/oracle.h"
#include "measure/numerics/run_kernel.h"

#include <string>

namespace lightbench::kernels {

// The number of a result that the oracle speaks of: by default its first float.
using Measure = std::function<double(std::span<const float> in, std::span<const float> out)>;
double first_float(std::span<const float> in, std::span<const float> out);
Measure component(std::size_t i); // the i-th float of a result

struct Verdict {
    bool holds = false;
    std::string message;     // failure: worst input in hexadecimal, expected, got; success: the worst share of the bound
    bool judged = false;     // false: not even compared (no inputs, unfinished invocations, an oracle in doubt); what follows is empty then
    double share = 0;        // of the bound at the worst input; above 1 fails
    double off = 0;          // |got - expected| there
    std::size_t outside = 0; // inputs outside of the bound
    std::vector<float> where{}; // the worst input
};

// Non-finite expectations must be met as such: NaN by NaN, an infinity by the same one.
Verdict judge(const KernelRun& run, const Oracle& oracle, const Bound& bound, const Measure& measure = first_float);

} // namespace lightbench::kernels
