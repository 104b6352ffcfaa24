// A report as `lightbench cost` might fill it: samples, a structure (time only), a pair of shader functions; and pictures for it.
#pragma once

#include "measure/report.h"

#include <filesystem>

namespace lightbench {

CostReport sample_report();

// Synthetic pictures of 64x36 under every name that the report mentions.
void write_sample_pictures(const CostReport& report, const std::filesystem::path& folder);

// The same report with text in every field that HTML, JSON, SVG, gnuplot or a shell would act upon.
CostReport hostile_report();

} // namespace lightbench
