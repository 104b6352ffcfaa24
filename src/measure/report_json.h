// cost.json: a whole CostReport, for --budget and for other people's scripts.
//
// { "program": str, "scene": str, "width": int, "height": int, "device": {"name": str, "driver": str, "version": str}, "command": str,
//   "curves": [{
//     "knob": str, "meaning": str, "metric": str, "time_only": bool,
//     "reference": {"how": str, "image": str, "command": str, "error": {METRIC: float}},   error: the reference's own uncertainty
//     "points": [{"value": str, "errors": {METRIC: float}, "device_ms": float, "q1_ms": float, "q3_ms": float, "runs": int, "settled": bool,
//                 "pareto": [METRIC], "image": str, "command": str, "options": {FLAG: str}, "note": str}],
//     "slopes": [{"of": str, "metric": str, "against": str, "measured": float, "theory": float or null, "why": str}],
//     "notes": [str] }] }
//
// METRIC as in measure/report.h. Times are milliseconds of device timestamps. Images lie below the report's folder. A number that is not finite
// is null.
#pragma once

#include "measure/report.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace lightbench {

struct ReportError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::string cost_json(const CostReport& report);

// What cost_json() wrote; null becomes NaN, and fronts are found anew. Throws ReportError: no JSON, not of this form, or with numbers that
// nothing measures.
CostReport read_cost_json(std::string_view text);

} // namespace lightbench
