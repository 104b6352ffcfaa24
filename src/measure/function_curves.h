// The pairs of stable and naive formulas as curves of a cost report. A point's milliseconds are those of 10^6 calls.
#pragma once

#include "gpu/device.h"
#include "measure/numerics/pairs.h"
#include "measure/report.h"

#include <vector>

namespace lightbench {

// One curve a pair: knob "sphere formula", points "stable", "naive", "naive in float64" where the device has it.
// Errors: "relative", "ulp", and "wrong": the share of inputs whose result is not finite, or a hit, miss or decision that is wrong.
std::vector<CostCurve> function_curves(gpu::Device& device, const kernels::PairLimits& limits = {});

CostCurve curve_of(const kernels::PairFinding& finding);

} // namespace lightbench
