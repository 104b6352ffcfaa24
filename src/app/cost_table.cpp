#include "app/cost_table.h"

#include "measure/knobs.h"
#include "measure/report_data.h"

#include <cmath>

#include <fmt/format.h>

namespace lightbench {
namespace {

// In the order of `metrics`; a dash where there is none.
std::string cells_of(const Errors& errors, const std::vector<std::string>& metrics) {
    std::string cells;
    for (const std::string& metric : metrics) {
        const auto error = errors.find(metric);
        cells += error == errors.end() ? fmt::format("{:>12}", "-") : fmt::format("{:>12.4g}", error->second);
    }
    return cells;
}

std::string time_of(const CostPoint& point) {
    if (!std::isfinite(point.device_ms)) return fmt::format("{:>10}", "-");
    if (point.runs == 1) return fmt::format("{:>10.3f}  (1 run)", point.device_ms);
    return fmt::format("{:>10.3f}  ({:.3f} to {:.3f}, {} runs)", point.device_ms, point.q1_ms, point.q3_ms, point.runs);
}

std::string point_line(const CostPoint& point, const std::string& metric, const std::vector<std::string>& metrics) {
    std::string line = fmt::format("{:<64}", fmt::format("  {:<18}{}", point.value, time_of(point))) + cells_of(point.errors, metrics);
    if (point.pareto.contains(metric)) line += "  front";
    if (!point.settled) line += "  unsettled";
    return line + (point.note.empty() ? "\n" : fmt::format("  {}\n", point.note));
}

std::string slope_line(const Slope& slope) {
    std::string line = fmt::format("  slope{} of {} against {}: {:.3f}", slope.of.empty() ? "" : fmt::format(" ({})", slope.of),
                                   slope.metric, slope.against, slope.measured);
    if (slope.theory) line += fmt::format(", theory {:g}", *slope.theory);
    return line + (slope.why.empty() ? "\n" : fmt::format(": {}\n", slope.why));
}

} // namespace

std::string knob_list() {
    std::string text;
    for (const Knob& knob : knobs()) {
        text += fmt::format("{:<14}{}\n", knob.name, knob.meaning);
        text += fmt::format("  values      {}\n", knob.values);
        if (!knob.defaults.empty()) text += fmt::format("  default     {}\n", fmt::join(knob.defaults, ", "));
        if (knob.defaults_of) text += "  default     the radius of the scene, 0.7 of it, its half, 0.35 and its quarter\n";
        if (!knob.method.empty()) text += fmt::format("  method      {}\n", knob.method);
        text += fmt::format("  reference   {}\n", knob.reference);
    }
    return text;
}

std::string curve_table(const CostCurve& curve) {
    std::string text = fmt::format("{}: {}\n  reference: {}\n", curve.knob, curve.meaning, curve.reference);
    std::string head = fmt::format("{:<64}", fmt::format("  {:<18}{:>10}  (quartiles)", "value", "ms"));
    const std::vector<std::string> metrics = metrics_of(curve);
    for (const std::string& metric : metrics) head += fmt::format("{:>12}", metric.substr(0, 11));
    text += head + "\n";
    for (const CostPoint& point : curve.points) text += point_line(point, curve.metric, metrics);
    if (!curve.reference_error.empty())
        text += fmt::format("{:<64}{}\n", "  uncertainty of the reference", cells_of(curve.reference_error, metrics));
    for (const Slope& slope : curve.slopes) text += slope_line(slope);
    for (const std::string& note : curve.notes) text += fmt::format("  {}\n", note);
    return text + "\n";
}

} // namespace lightbench
