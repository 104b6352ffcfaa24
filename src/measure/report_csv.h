// cost.csv: a line for each metric of each point.
#pragma once

#include "measure/report.h"

namespace lightbench {

// RFC 4180; numbers in the fewest digits that read back as the same.
std::string cost_csv(const CostReport& report);

std::string csv_field(const std::string& text); // in quotes if it must be

} // namespace lightbench
