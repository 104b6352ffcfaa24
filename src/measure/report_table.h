// The report's tables as HTML. Numbers are rounded for the eye; each cell keeps all of its digits for sorting and as its title.
#pragma once

#include "measure/report.h"

namespace lightbench {

std::string point_table(const CostCurve& curve);
std::string slope_table(const CostCurve& curve); // empty if there are none

} // namespace lightbench
