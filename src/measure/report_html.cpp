#include "measure/report_html.h"

#include "measure/page.h"
#include "measure/report_data.h"
#include "measure/report_table.h"
#include "measure/text.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

std::string term(const char* name, const std::string& html) {
    return html.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html);
}

std::string command(const std::string& text) {
    return text.empty() ? "" : fmt::format("<code class=\"copy\">{}</code>", html_escaped(text));
}

std::string count_of(std::size_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string head(const CostReport& report) {
    std::string html = "<header>\n<h1>What accuracy costs in time</h1>\n<dl>\n";
    html += term("scene", html_escaped(report.scene)) + term("size", fmt::format("{} x {} pixels", report.width, report.height));
    html += term("device", html_escaped(report.device)) + term("driver", html_escaped(fmt::format("{} {}", report.driver, report.version)));
    html += term("program", html_escaped(report.program)) + term("repeat it", command(report.command)) +
            "</dl>\n<nav aria-label=\"knobs\"><ul>\n";
    for (std::size_t i = 0; i < report.curves.size(); ++i) {
        const std::size_t warnings = report.curves[i].notes.size();
        html += fmt::format("<li><a href=\"#curve-{}\">{}</a>{}</li>\n", i, html_escaped(report.curves[i].knob),
                            warnings ? fmt::format(" <span class=\"flag\">\u26a0 {}</span>", count_of(warnings, "note")) : "");
    }
    return html +
           "</ul></nav>\n<p class=\"soft\">Times are those of the device, from its own timestamps: the median of interleaved runs, bars "
           "from the "
           "first to the third quartile. A point is on the Pareto front if none on it is both faster and nearer to the reference; times "
           "whose bars overlap are equal.</p>\n"
           "<noscript><p class=\"warning\">Without script the tables are here; charts and pictures are not.</p></noscript>\n</header>\n";
}

std::string warnings(const CostCurve& curve) {
    std::string items;
    for (const std::string& note : curve.notes) items += fmt::format("<li>{}</li>", html_escaped(note));
    return items.empty() ? "" : fmt::format("<div class=\"warning\" role=\"note\"><strong>\u26a0 Note</strong><ul>{}</ul></div>\n", items);
}

std::string uncertainty(const CostCurve& curve) {
    std::string html;
    for (const auto& [metric, error] : curve.reference_error)
        html += fmt::format("{}{} {:.3g}", html.empty() ? "" : ", ", html_escaped(metric), error);
    return html;
}

std::string section(const CostCurve& curve, std::size_t index) {
    std::string html = fmt::format("<section id=\"curve-{}\">\n<h2>{} <small>{}</small></h2>\n<dl>\n", index, html_escaped(curve.knob),
                                   html_escaped(curve.meaning));
    html += term("reference", html_escaped(curve.reference)) + term("its own error", uncertainty(curve));
    html += term("computed by", command(curve.reference_command)) + "</dl>\n";
    if (curve.time_only) html += "<p class=\"soft\">The pictures must be equal whatever the setting: only time differs.</p>\n";
    html += warnings(curve) + "<div class=\"bench\"><div class=\"chart\"></div><figure class=\"viewer\"></figure></div>\n";
    return html + slope_table(curve) + point_table(curve) + "</section>\n";
}

std::string body(const CostReport& report) {
    std::string html = head(report) + "<main>\n";
    for (std::size_t i = 0; i < report.curves.size(); ++i) html += section(report.curves[i], i);
    return html + "</main>";
}

// {{name}} replaced by its value, once: what a value holds is never looked into.
std::string filled(std::string_view form, const std::map<std::string_view, std::string_view>& values) {
    std::string out;
    for (std::size_t open = form.find("{{"); open != std::string_view::npos; open = form.find("{{")) {
        const std::size_t close = form.find("}}", open);
        out += form.substr(0, open);
        out += values.at(form.substr(open + 2, close - open - 2));
        form.remove_prefix(close + 2);
    }
    return out.append(form);
}

} // namespace

std::string report_html(const CostReport& report, const std::filesystem::path& folder) {
    std::string scripts;
    for (const char* part : {"labels.js", "chart.js", "viewer.js", "table.js", "main.js"}) scripts += page_part(part);
    const std::string title = html_escaped(fmt::format("{}: what accuracy costs in time", report.scene));
    const std::string all = body(report), data = report_data(report, folder);
    return filled(page_part("page.html"), {{"title", title},
                                           {"style", page_part("page.css")},
                                           {"d3", page_part("d3.min.js")},
                                           {"scripts", scripts},
                                           {"data", data},
                                           {"body", all}});
}

} // namespace lightbench
