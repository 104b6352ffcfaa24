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

constexpr unsigned kWidth = 900;
constexpr unsigned kLine = 18;        // pixels of a line of small text
constexpr std::size_t kColumns = 122; // letters of a line below the title

unsigned height_of(const Plot& plot) {
    return 520 + kLine * static_cast<unsigned>(plot.lines.size());
}

// The title and its notes at the top, the names of the lines at the bottom, the plot between.
std::string frame(const Plot& plot) {
    const double key = kLine * static_cast<double>(plot.lines.size()), bottom = key + (plot.polar ? 24 : 66), height = height_of(plot);
    std::vector<std::string> lines;
    for (const std::string& note : plot.notes)
        for (std::string& line : wrapped(note, kColumns)) lines.push_back(std::move(line));
    std::string script = fmt::format("set label {} at screen 0.03,{} left font ',17'\n", gnuplot_quoted(plot.title), 1 - 26.0 / height);
    double top = height - 50;
    for (const std::string& line : lines) {
        script +=
            fmt::format("set label {} at screen 0.03,{} left font ',12' textcolor rgb '#555555'\n", gnuplot_quoted(line), top / height);
        top -= kLine;
    }
    script += fmt::format("set tmargin at screen {}\nset bmargin at screen {}\nset rmargin at screen 0.97\nset lmargin at screen {}\n",
                          (top - 2) / height, bottom / height, plot.polar ? 0.03 : 0.1);
    script += fmt::format("set key at screen 0.08,{} left bottom vertical maxcols 1 reverse Left font ',12' samplen 3\n", 8.0 / height);
    if (!plot.polar)
        script +=
            fmt::format("set label {} at screen 0.02,{} center rotate\n", gnuplot_quoted(plot.y_label), 0.5 * (top + bottom) / height);
    return script;
}

double largest_radius(const Plot& plot) {
    double largest = 0;
    for (const PlotLine& line : plot.lines)
        for (const glm::dvec2& p : line.points) largest = std::max(largest, p.y);
    return largest > 0 ? largest : 1;
}

glm::dvec2 at_angle(double degrees, double radius) {
    const double angle = degrees * (std::numbers::pi / 180);
    return radius * glm::dvec2(std::sin(angle), std::cos(angle));
}

constexpr const char* kSmall = "font ',11' textcolor rgb '#777777'";

// The half plane above the surface: gnuplot's own polar axes are of the whole circle.
std::string polar_axes(const Plot& plot) {
    const double r = largest_radius(plot);
    std::string script = fmt::format("set size ratio -1\nunset border\nunset tics\nunset grid\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
                                     -1.12 * r, 1.12 * r, -0.06 * r, 1.1 * r);
    script += fmt::format("set arrow from {},0 to {},0 nohead linecolor rgb '#444444' linewidth 1.5\n", -1.05 * r, 1.05 * r);
    script += fmt::format("set label 'surface' at {},{} left {}\n", -1.05 * r, -0.03 * r, kSmall);
    for (int degrees = -75; degrees <= 75; degrees += 15) {
        const glm::dvec2 end = at_angle(degrees, r), text = at_angle(degrees, 1.045 * r);
        script += fmt::format("set label '{}\u00b0' at {},{} center {}\n", std::abs(degrees), text.x, text.y, kSmall);
        script += fmt::format("set arrow from 0,0 to {},{} nohead back linecolor rgb '#e4e4e4'\n", end.x, end.y);
    }
    for (int ring = 1; ring <= 4; ++ring)
        script += fmt::format("set label '{:.3g}' at {},{} center {}\n", r * ring / 4, r * ring / 4, -0.03 * r, kSmall);
    for (const double degrees : plot.rays) {
        const glm::dvec2 from = at_angle(-degrees, r), to = at_angle(-degrees, 0.5 * r), text = at_angle(-degrees, 0.78 * r);
        script +=
            fmt::format("set arrow from {},{} to {},{} head filled linecolor rgb '#888888' linewidth 1.5\n", from.x, from.y, to.x, to.y);
        script += fmt::format("set label 'light' at {},{} left offset 1,0.3 {}\n", text.x, text.y, kSmall);
    }
    return script;
}

// Half circles at quarters of the largest radius.
std::string rings(double radius) {
    std::string rows = "$rings << EOD\n";
    for (int ring = 1; ring <= 4; ++ring) {
        for (int degrees = -90; degrees <= 90; degrees += 2) {
            const glm::dvec2 p = at_angle(degrees, radius * ring / 4);
            rows += fmt::format("{} {}\n", p.x, p.y);
        }
        rows += "\n";
    }
    return rows + "EOD\n";
}

std::string straight_axes(const Plot& plot) {
    std::string script = fmt::format("set xlabel {}\n", gnuplot_quoted(plot.x_label));
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
    for (const glm::dvec2& p : plot.lines[index].points) {
        const glm::dvec2 at = plot.polar ? at_angle(p.x, p.y) : p;
        rows += drawable(plot, p) ? fmt::format("{} {}\n", at.x, at.y) : std::string("\n");
    }
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
    std::string script = gnuplot_style(kWidth, height_of(plot)) + frame(plot) + (plot.polar ? polar_axes(plot) : straight_axes(plot));
    std::string lines = "plot ";
    if (plot.polar) script += rings(largest_radius(plot)), lines += "$rings using 1:2 with lines linecolor rgb '#e4e4e4' notitle, ";
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        const PlotLine& line = plot.lines[i];
        script += block(plot, i);
        const std::string how = line.marks
                                    ? fmt::format("with points linetype {} pointtype {} pointsize 0.6", line.color, line.dash == 1 ? 6 : 8)
                                    : fmt::format("with lines linetype {} dashtype {} linewidth 1.6", line.color, line.dash);
        lines += fmt::format("{}$line{} using 1:2 {} title {}", i ? ", " : "", i, how, gnuplot_quoted(line.name));
    }
    return run_gnuplot(script + lines + "\n");
}

} // namespace lightbench
