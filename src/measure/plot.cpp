#include "measure/plot.h"

#include "measure/gnuplot.h"
#include "measure/labels.h"
#include "measure/report_csv.h"
#include "measure/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace lightbench {
namespace {

constexpr unsigned kWidth = 900, kHeight = 640;
constexpr std::size_t kColumns = 122; // letters of a line below the title

std::string heading(const Plot& plot) {
    std::vector<std::string> lines;
    for (const std::string& note : plot.notes)
        for (std::string& line : wrapped(note, kColumns)) lines.push_back(std::move(line));
    std::string script = fmt::format("set label {} at screen 0.03,{} left font ',17'\n", gnuplot_quoted(plot.title), 1 - 26.0 / kHeight);
    double y = kHeight - 50;
    for (const std::string& line : lines) {
        script +=
            fmt::format("set label {} at screen 0.03,{} left font ',12' textcolor rgb '#555555'\n", gnuplot_quoted(line), y / kHeight);
        y -= 18;
    }
    return script + fmt::format("set tmargin at screen {}\n", (y - 2) / kHeight);
}

double largest_radius(const Plot& plot) {
    double largest = 0;
    for (const PlotLine& line : plot.lines)
        for (const glm::dvec2& p : line.points) largest = std::max(largest, p.y);
    return largest > 0 ? largest * 1.02 : 1;
}

// The half plane above the surface; gnuplot's own polar axes would show the whole circle.
std::string polar_frame(const Plot& plot) {
    const double r = largest_radius(plot);
    std::string script =
        fmt::format("set polar\nset angles degrees\nset theta top clockwise\nset size ratio -1\nunset border\nunset xtics\nunset ytics\n"
                    "set xrange [{}:{}]\nset yrange [0:{}]\nset rrange [0:{}]\nset grid polar 15\nset rtics scale 0 font ',11' "
                    "textcolor rgb '#777777'\nset label 'surface' at {},{} right font ',11' textcolor rgb '#777777'\n"
                    "set arrow from {},0 to {},0 nohead linecolor rgb '#444444' linewidth 1.5\n",
                    -r, r, r, r, r, -0.03 * r, -r, r);
    for (int degrees = -75; degrees <= 75; degrees += 15) {
        const double angle = degrees * (std::numbers::pi / 180);
        script += fmt::format("set label '{}\u00b0' at {},{} center font ',11' textcolor rgb '#777777'\n", std::abs(degrees),
                              1.035 * r * std::sin(angle), 1.035 * r * std::cos(angle));
    }
    for (const double degrees : plot.rays) {
        const double angle = degrees * (std::numbers::pi / 180), x = -r * std::sin(angle), y = r * std::cos(angle);
        script +=
            fmt::format("set arrow from {},{} to {},{} head filled linecolor rgb '#999999' linewidth 1.2\n", x, y, 0.55 * x, 0.55 * y);
        script += fmt::format("set label 'light' at {},{} left offset 0.6,0.4 font ',11' textcolor rgb '#777777'\n", 0.78 * x, 0.78 * y);
    }
    return script;
}

std::string straight_frame(const Plot& plot) {
    std::string script = fmt::format("set xlabel {}\nset ylabel {}\nset lmargin at screen 0.1\nset rmargin at screen 0.97\n",
                                     gnuplot_quoted(plot.x_label), gnuplot_quoted(plot.y_label));
    if (plot.log_x) script += "set logscale x\n";
    if (plot.log_y) script += "set logscale y\n";
    return script + "set format '%g'\nset autoscale xfixmin\nset autoscale xfixmax\n";
}

bool drawable(const Plot& plot, const glm::dvec2& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && (!plot.log_x || p.x > 0) && (!plot.log_y || p.y > 0);
}

// gnuplot refuses a block without rows.
std::string block(const Plot& plot, std::size_t index) {
    std::string rows;
    for (const glm::dvec2& p : plot.lines[index].points) rows += drawable(plot, p) ? fmt::format("{} {}\n", p.x, p.y) : std::string("\n");
    return fmt::format("$line{} << EOD\n{}EOD\n", index, rows.find_first_not_of('\n') == std::string::npos ? "NaN NaN\n" : rows);
}

} // namespace

std::string plot_csv(const Plot& plot) {
    std::string csv = fmt::format("curve,{},{}\n", plot.x_key, plot.y_key);
    for (const PlotLine& line : plot.lines)
        for (const glm::dvec2& p : line.points) csv += fmt::format("{},{},{}\n", csv_field(line.name), p.x, p.y);
    return csv;
}

std::string plot_svg(const Plot& plot) {
    std::string script = gnuplot_style(kWidth, kHeight) + heading(plot) + (plot.polar ? polar_frame(plot) : straight_frame(plot));
    script += "set key below left reverse Left font ',12' samplen 3 width 1\n";
    std::string lines;
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        const PlotLine& line = plot.lines[i];
        script += block(plot, i);
        const std::string how = line.marks ? fmt::format("with points linetype {} pointtype 6 pointsize 0.6", line.color)
                                           : fmt::format("with lines linetype {} dashtype {} linewidth 1.6", line.color, line.dash);
        lines += fmt::format("{}$line{} using 1:2 {} title {}", i ? ", " : "plot ", i, how, gnuplot_quoted(line.name));
    }
    return run_gnuplot(script + lines + "\n");
}

} // namespace lightbench
