#include "measure/report_plots.h"

#include "image/file_bytes.h"
#include "measure/report_svg.h"
#include "measure/text.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {

std::vector<PlotFile> plot_files(const CostReport& report) {
    std::vector<PlotFile> files;
    std::set<std::string> names;
    const auto add = [&](std::size_t curve, const std::string& metric) {
        const std::string stem = file_word(report.curves[curve].knob) + "-" + (metric.empty() ? "time" : file_word(metric));
        std::string name = stem; // a knob may come twice
        for (int n = 2; !names.insert(name).second; ++n) name = fmt::format("{}-{}", stem, n);
        files.push_back({name + ".svg", curve, metric});
    };
    for (std::size_t i = 0; i < report.curves.size(); ++i) {
        const CostCurve& curve = report.curves[i];
        add(i, curve.time_only ? "" : curve.metric);
        const bool pictures = std::ranges::any_of(curve.points, [](const CostPoint& p) { return !p.image.empty(); });
        if (!curve.time_only && pictures && curve.metric != "flip") add(i, "flip");
    }
    return files;
}

void write_cost_plots(const CostReport& report, const std::filesystem::path& folder) {
    for (const PlotFile& file : plot_files(report)) {
        const CostCurve& curve = report.curves[file.curve];
        write_file((folder / file.name).string(), file.metric.empty() ? time_plot(report, curve) : cost_plot(report, curve, file.metric));
    }
}

} // namespace lightbench
