// The pairs of stable and naive formulas as curves of a cost report. A point's milliseconds are those of 10^6 calls.
#pragma once

#include "gpu/device.h"
#include "measure/numerics/pairs.h"
#include "measure/report.h"

#include <vector>

namespace lightbench {

// One curve a pair: knob "sphere formula", points "stable", "naive", "naive in float64" where the device has it.
// Errors: "relative", "ulp" (not of decisions), and "wrong": the share of inputs whose result is not finite, or a hit, miss or decision that is
// wrong. The first two are infinite for a form that is wrong where the stable one is not. A time that is lost in noise is NaN.
// `stop`: asked before each pair; true: no further one.
std::vector<CostCurve> function_curves(gpu::Device& device, const kernels::PairLimits& limits = {}, const std::function<bool()>& stop = {});

CostCurve curve_of(const kernels::PairFinding& finding);

} // namespace lightbench
