#include "measure/report_csv.h"

#include <fmt/format.h>

namespace lightbench {

std::string csv_field(const std::string& text) {
    if (text.find_first_of("\",\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
}

std::string cost_csv(const CostReport& report) {
    std::string csv = "knob,value,metric,error,device_ms,q1_ms,q3_ms,runs,pareto,image\n";
    for (const CostCurve& curve : report.curves)
        for (const CostPoint& point : curve.points)
            for (const auto& [metric, error] : point.errors)
                csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_field(curve.knob), csv_field(point.value), csv_field(metric),
                                   error, point.device_ms, point.q1_ms, point.q3_ms, point.runs, point.pareto.contains(metric) ? 1 : 0,
                                   csv_field(point.image));
    return csv;
}

} // namespace lightbench
