#include "measure/report_table.h"

#include "measure/report_data.h"
#include "measure/text.h"

#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

std::string number_cell(double value) {
    if (!std::isfinite(value)) return fmt::format("<td data-sort=\"\">{}</td>", value);
    return fmt::format("<td data-sort=\"{0}\" title=\"{0}\">{0:.4g}</td>", value);
}

std::string error_cell(const CostPoint& point, const std::string& metric) {
    const auto error = point.errors.find(metric);
    return error == point.errors.end() ? "<td data-sort=\"\"><span class=\"soft\">none</span></td>" : number_cell(error->second);
}

std::string pareto_text(const CostPoint& point, std::size_t metrics) {
    if (point.pareto.size() == metrics && metrics > 1) return "in all";
    std::string text;
    for (const std::string& metric : point.pareto) text += (text.empty() ? "" : ", ") + html_escaped(metric);
    return text;
}

// The note stands under the setting's name: a column of its own would be out of sight.
std::string name_cell(const CostPoint& point, std::size_t index) {
    const std::string note = point.note.empty() ? "" : fmt::format("<div class=\"note\">\u26a0 {}</div>", html_escaped(point.note));
    return fmt::format("<th scope=\"row\" data-sort=\"{}\">{}{}</th>", index, html_escaped(point.value), note);
}

std::string row_of(const CostCurve& curve, std::size_t index, const std::vector<std::string>& metrics) {
    const CostPoint& point = curve.points[index];
    const bool best = curve.time_only ? !point.pareto.empty() : point.pareto.contains(curve.metric);
    std::string row = fmt::format("<tr data-index=\"{}\"{}>", index, best ? " class=\"best\"" : "") + name_cell(point, index);
    for (const std::string& metric : metrics) row += error_cell(point, metric);
    row += number_cell(point.device_ms) + number_cell(point.q1_ms) + number_cell(point.q3_ms);
    row += fmt::format("<td data-sort=\"{0}\">{0}</td><td class=\"text\" data-sort=\"{1}\">{2}</td>", point.runs, point.settled ? 1 : 0,
                       point.settled ? "yes" : "<span class=\"flag\">\u26a0 no</span>");
    row += fmt::format("<td class=\"text\" data-sort=\"{}\">{}</td><td class=\"picture text\"></td><td class=\"command text\">",
                       point.pareto.size(), pareto_text(point, metrics.size()));
    if (!point.command.empty()) row += fmt::format("<code class=\"copy\" title=\"{0}\">{0}</code>", html_escaped(point.command));
    return row + "</td></tr>\n";
}

std::string heading(const std::string& html, bool text = false) {
    return fmt::format("<th scope=\"col\" data-sortable{}>{}</th>", text ? " class=\"text\"" : "", html);
}

std::string table(const std::string& headings, const std::string& rows, const char* kind) {
    return fmt::format("<div class=\"scroll\" tabindex=\"0\"><table{}>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
                       kind, headings, rows);
}

} // namespace

std::string point_table(const CostCurve& curve) {
    const std::vector<std::string> metrics = metrics_of(curve);
    std::string headings = heading(html_escaped(curve.knob), true), rows;
    for (const std::string& metric : metrics) headings += heading(html_escaped(metric));
    for (const char* name : {"median ms", "q1 ms", "q3 ms", "runs"}) headings += heading(name);
    headings += heading("settled", true) + heading("Pareto front", true);
    for (const char* name : {"picture", "command"}) headings += fmt::format("<th scope=\"col\" class=\"text\">{}</th>", name);
    for (std::size_t i = 0; i < curve.points.size(); ++i) rows += row_of(curve, i, metrics);
    return "<h3>All points</h3>\n" + table(headings, rows, " class=\"sortable\"");
}

std::string slope_table(const CostCurve& curve) {
    if (curve.slopes.empty()) return "";
    std::string rows;
    for (const Slope& slope : curve.slopes)
        rows +=
            fmt::format("<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{:.3f}</td><td>{}</td>"
                        "<td class=\"text wrap\">{}</td></tr>\n",
                        html_escaped(slope.of.empty() ? "all points" : slope.of), html_escaped(slope.metric), html_escaped(slope.against),
                        slope.measured, slope.theory ? fmt::format("{:.3g}", *slope.theory) : "<span class=\"soft\">none</span>",
                        html_escaped(slope.why));
    const std::string headings =
        "<th scope=\"col\" class=\"text\">of</th><th scope=\"col\" class=\"text\">error</th><th scope=\"col\" class=\"text\">against</th>"
        "<th scope=\"col\">measured</th><th scope=\"col\">theory</th><th scope=\"col\" class=\"text\">why</th>";
    return "<h3>Slopes: how the error falls, as a power</h3>\n" + table(headings, rows, "");
}

} // namespace lightbench
