// The SVG files of a report: KNOB-METRIC.svg for each curve's main metric and FLIP; KNOB-time.svg where only time differs.
#pragma once

#include "measure/report.h"

#include <filesystem>

namespace lightbench {

struct PlotFile {
    std::string name;
    std::size_t curve = 0;
    std::string metric; // empty: time only
};

// Of a report, or of the outline of one, whose points have no errors yet.
std::vector<PlotFile> plot_files(const CostReport& report);

// Each file appears whole or not at all. Throws gpu::EnvironmentError if gnuplot cannot draw, FileError if a file cannot be written.
void write_cost_plots(const CostReport& report, const std::filesystem::path& folder);

} // namespace lightbench
