// Error against time as pictures, drawn by gnuplot. In: a curve. Out: an SVG's text. Throws gpu::EnvironmentError.
#pragma once

#include "measure/report.h"

namespace lightbench {

std::string cost_plot(const CostReport& report, const CostCurve& curve, const std::string& metric);
std::string time_plot(const CostReport& report, const CostCurve& curve);

// With what it is measured: "linear light", "ulp".
std::string unit_of(const std::string& metric);

} // namespace lightbench
