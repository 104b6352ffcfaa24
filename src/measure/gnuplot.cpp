#include "measure/gnuplot.h"

#include "gpu/errors.h"
#include "image/child_process.h"
#include "measure/text.h"

#include <fmt/format.h>

namespace lightbench {

std::string gnuplot_style(unsigned width, unsigned height) {
    std::string style = fmt::format("set encoding utf8\nset terminal svg size {},{} dynamic noenhanced background '#ffffff' "
                                    "font 'DejaVu Sans,Helvetica,Arial,sans-serif,14' linewidth 1.2\n",
                                    width, height);
    int number = 0;
    for (const char* color : {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#a6761d"})
        style += fmt::format("set linetype {} linecolor rgb '{}'\n", ++number, color);
    return style + "set grid linecolor rgb '#dddddd' linewidth 0.6\nset border linecolor rgb '#666666'\nset tics textcolor rgb '#222222'\n";
}

bool has_gnuplot() {
    return run_child({"gnuplot", "--version"}, "", std::chrono::seconds(10)).code == 0;
}

std::string run_gnuplot(const std::string& script) {
    constexpr std::chrono::seconds kLimit(30); // a plot takes a tenth of one
    ChildResult child = run_child({"gnuplot", "-d"}, script, kLimit);
    if (child.timed_out) throw gpu::EnvironmentError(fmt::format("gnuplot took more than {} s for a plot and was ended", kLimit.count()));
    if (!child.started()) throw gpu::EnvironmentError("gnuplot, which draws the SVG plots, cannot be run; Debian's package is gnuplot-nox");
    if (child.code != 0 || !child.err.empty() || child.out.find("</svg>") == std::string::npos)
        throw gpu::EnvironmentError(fmt::format("gnuplot drew no plot: {}", child.err.empty() ? "it ended early" : printable(child.err)));
    return std::move(child.out);
}

} // namespace lightbench
