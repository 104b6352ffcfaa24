// Error against time as pictures: KNOB-METRIC.svg for each curve's main metric and FLIP; KNOB-time.svg where only time differs.
#pragma once

#include "measure/report.h"

#include <filesystem>

namespace lightbench {

// Each file appears whole or not at all. Throws gpu::EnvironmentError if gnuplot cannot draw, FileError if a file cannot be written.
void write_cost_plots(const CostReport& report, const std::filesystem::path& folder);

// One of them: the SVG's text.
std::string cost_plot(const CostReport& report, const CostCurve& curve, const std::string& metric);
std::string time_plot(const CostReport& report, const CostCurve& curve);

// With what it is measured: "linear light", "ulp".
std::string unit_of(const std::string& metric);

} // namespace lightbench
