// What `lightbench cost` prints: results for standard output.
#pragma once

#include "measure/report.h"

#include <string>

namespace lightbench {

std::string knob_list();                         // every knob: name, meaning, values, reference
std::string curve_table(const CostCurve& curve); // points, slopes, notes

} // namespace lightbench
