// Curves of a report drawn by gnuplot. Margins and ranges are set here, so that the pixel of every point is known and its name can be placed.
#include "measure/report_svg.h"

#include "measure/gnuplot.h"
#include "measure/labels.h"
#include "measure/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace lightbench {
namespace {

constexpr unsigned kWidth = 900, kHeight = 640;
constexpr double kNoBar = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kColumns = 118; // letters of a line below the title

struct Axis {
    double low = 0, high = 1;
    bool logarithmic = false;
    double share(double value) const { // 0 at the low end, 1 at the high one
        return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    }
};

struct Dot {
    const CostPoint* point;
    double error;           // as drawn
    bool on_front, on_edge; // on_edge: the error is 0, and the axis has no place for it
};

struct Chart {
    Axis time, error;
    std::vector<Dot> dots;
    std::vector<std::string> heading; // below the title
    PlotBox area;                     // pixels, y upwards
    glm::dvec2 pixel(double t, double e) const { return area.low + (area.high - area.low) * glm::dvec2(time.share(t), error.share(e)); }
};

Axis axis_over(const std::vector<double>& values, double padding) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (values.empty()) return {};
    if (*low > 0) {
        const double margin = std::pow(std::max(*high / *low, 4.0), padding);
        return {*low / margin, *high * margin, true};
    }
    const double margin = padding * std::max({*high - *low, std::abs(*high), 1e-9});
    return {*low - (*low < 0 ? margin : 0), *high + margin, false};
}

Axis time_axis(const CostCurve& curve) {
    std::vector<double> times;
    for (const CostPoint& p : curve.points)
        for (const double t : {p.q1_ms, p.device_ms, p.q3_ms})
            if (std::isfinite(t)) times.push_back(t);
    return axis_over(times, 0.09);
}

std::vector<std::string> heading_of(const CostReport& report, const CostCurve& curve) {
    std::vector<std::string> lines = wrapped(
        fmt::format("scene {}, {}x{}, on {}", printable(report.scene), report.width, report.height, printable(report.device)), kColumns);
    if (!curve.reference.empty())
        for (std::string& line : wrapped("reference: " + printable(curve.reference), kColumns)) lines.push_back(std::move(line));
    return lines;
}

// Points with a finite error. An error of 0 has no place on a logarithmic axis: it is drawn on the lower edge, and the heading says so.
void gather(Chart& chart, const CostCurve& curve, const std::string& metric) {
    std::vector<double> positive;
    std::size_t left_out = 0, zeros = 0;
    for (const CostPoint& point : curve.points) {
        const auto error = point.errors.find(metric);
        if (error == point.errors.end() || !std::isfinite(error->second) || !std::isfinite(point.device_ms)) {
            ++left_out;
            continue;
        }
        if (error->second > 0) positive.push_back(error->second);
        zeros += error->second == 0;
        chart.dots.push_back({&point, error->second, point.pareto.contains(metric), false});
    }
    chart.error = axis_over(positive, 0.12);
    if (zeros > 0 && !positive.empty()) {
        chart.error.low /= std::pow(chart.error.high / chart.error.low, 0.1);
        for (Dot& dot : chart.dots)
            if (dot.error == 0) dot.error = chart.error.low, dot.on_edge = true;
        chart.heading.emplace_back("triangles on the lower edge: the error is 0");
    }
    if (left_out > 0)
        chart.heading.push_back(fmt::format("not drawn: {} of {} points, which have no {}", left_out, curve.points.size(), metric));
}

void lay_out(Chart& chart, double left) {
    const double top = 54 + 18.0 * static_cast<double>(chart.heading.size());
    chart.area = {{left, 96}, {kWidth - 28, kHeight - top}};
}

std::string frame(const Chart& chart, const std::string& title) {
    const PlotBox& a = chart.area;
    std::string script = gnuplot_style(kWidth, kHeight);
    script += fmt::format("set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n",
                          a.low.x / kWidth, a.high.x / kWidth, a.low.y / kHeight, a.high.y / kHeight);
    script += fmt::format("set label {} at screen 0.03,{} left font ',17'\n", gnuplot_quoted(title), 1 - 26.0 / kHeight);
    double y = kHeight - 50;
    for (const std::string& line : chart.heading) {
        script +=
            fmt::format("set label {} at screen 0.03,{} left font ',12' textcolor rgb '#555555'\n", gnuplot_quoted(line), y / kHeight);
        y -= 18;
    }
    script += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", chart.time.low, chart.time.high, chart.error.low, chart.error.high);
    if (chart.time.logarithmic) script += "set logscale x\n";
    if (chart.error.logarithmic) script += "set logscale y\n";
    return script + fmt::format("set xlabel 'time on the device in ms (median; bars: quartiles)'\nset key at screen {},{} right bottom "
                                "horizontal reverse Left samplen 2 font ',12' width -1\nset bars 0.5\n",
                                a.high.x / kWidth, 6.0 / kHeight);
}

// 1, 2 and 5 of each ten where there is room for them, else powers of ten, or every other one.
std::string tics(char name, const Axis& axis, double pixels, double room) {
    if (!axis.logarithmic) return "";
    const std::pair<std::vector<double>, int> choices[] = {
        {{1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9}, 1}, {{1, 2, 5}, 1}, {{1}, 1}, {{1}, 2}, {{1}, 5}};
    std::string list;
    for (const auto& [digits, step] : choices) {
        double count = 0;
        list.clear();
        for (int power = static_cast<int>(std::floor(std::log10(axis.low))); std::pow(10, power) <= axis.high; ++power)
            for (const double digit : digits) {
                const double at = digit * std::pow(10, power);
                if (power % step == 0 && at >= axis.low && at <= axis.high)
                    ++count, list += fmt::format("{}{:g}", list.empty() ? "" : ",", at);
            }
        if (count * room <= pixels) break;
    }
    return fmt::format("set {}tics ({})\n", name, list);
}

// Fewest milliseconds first: the order in which its staircase is climbed down.
std::vector<glm::dvec2> front_of(const Chart& chart) {
    std::vector<glm::dvec2> front;
    for (const Dot& dot : chart.dots)
        if (dot.on_front) front.emplace_back(dot.point->device_ms, dot.error);
    std::sort(front.begin(), front.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
    return front;
}

// What names should not cover: points, their bars, the steps of the front.
std::vector<PlotBox> obstacles_in(const Chart& chart) {
    std::vector<PlotBox> boxes;
    for (const Dot& dot : chart.dots) {
        const glm::dvec2 p = chart.pixel(dot.point->device_ms, dot.error);
        boxes.push_back({p - 5.0, p + 5.0});
        boxes.push_back({{chart.pixel(dot.point->q1_ms, dot.error).x, p.y - 2}, {chart.pixel(dot.point->q3_ms, dot.error).x, p.y + 2}});
    }
    const std::vector<glm::dvec2> front = front_of(chart);
    for (std::size_t i = 1; i < front.size(); ++i) {
        const glm::dvec2 a = chart.pixel(front[i - 1].x, front[i - 1].y), b = chart.pixel(front[i].x, front[i].y);
        boxes.push_back({{a.x, a.y - 1}, {b.x, a.y + 1}});
        boxes.push_back({{b.x - 1, std::min(a.y, b.y)}, {b.x + 1, std::max(a.y, b.y)}});
    }
    return boxes;
}

std::string names_of_dots(const Chart& chart) {
    std::vector<PlotLabel> labels;
    labels.reserve(chart.dots.size());
    for (const Dot& dot : chart.dots)
        labels.push_back({shortened(printable(dot.point->value), 28), chart.pixel(dot.point->device_ms, dot.error)});
    const std::vector<PlotBox> boxes = place_labels(labels, chart.area, obstacles_in(chart));
    std::string script;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const glm::dvec2 middle = 0.5 * (boxes[i].low + boxes[i].high), p = labels[i].point;
        const glm::dvec2 near = glm::clamp(p, boxes[i].low, boxes[i].high);
        script += fmt::format("set label {} at screen {},{} center font ',12'\n", gnuplot_quoted(labels[i].text), middle.x / kWidth,
                              middle.y / kHeight);
        if (glm::distance(near, p) > 16)
            script += fmt::format("set arrow from screen {},{} to screen {},{} nohead linecolor rgb '#aaaaaa' linewidth 0.7\n",
                                  near.x / kWidth, near.y / kHeight, p.x / kWidth, p.y / kHeight);
    }
    return script;
}

std::string rows_where(const Chart& chart, const std::string& name, const auto& wanted) {
    std::string block = "$" + name + " << EOD\n";
    for (const Dot& dot : chart.dots)
        if (wanted(dot)) {
            const bool noise = dot.point->runs > 1; // one run has none to show
            block += fmt::format("{} {} {} {}\n", dot.point->device_ms, dot.error, noise ? dot.point->q1_ms : kNoBar,
                                 noise ? dot.point->q3_ms : kNoBar);
        }
    return block + "EOD\n";
}

std::string front_rows(const Chart& chart) {
    std::string block = "$front << EOD\n";
    for (const glm::dvec2& p : front_of(chart)) block += fmt::format("{} {}\n", p.x, p.y);
    return block + "EOD\n";
}

std::string drawn(const Chart& chart) {
    std::string script = rows_where(chart, "all", [](const Dot&) { return true; });
    script += rows_where(chart, "edge", [](const Dot& d) { return d.on_edge; });
    script += rows_where(chart, "others", [](const Dot& d) { return !d.on_edge && !d.on_front; });
    script += rows_where(chart, "best", [](const Dot& d) { return !d.on_edge && d.on_front; });
    script += front_rows(chart);
    // A block without rows is an error of gnuplot's.
    std::string plots;
    const auto add = [&](const char* block, const std::string& how) {
        if (script.find(fmt::format("${} << EOD\nEOD", block)) == std::string::npos)
            plots += fmt::format("{}${} {}", plots.empty() ? "plot " : ", ", block, how);
    };
    add("front", "using 1:2 with steps linetype 2 linewidth 1.5 title 'Pareto front'");
    add("all", "using 1:2:3:4 with xerrorbars linecolor rgb '#666666' pointtype 0 linewidth 1 notitle");
    add("others", "using 1:2 with points linetype 1 pointtype 6 pointsize 0.8 linewidth 1.5 title 'dominated'");
    add("best", "using 1:2 with points linetype 2 pointtype 7 pointsize 0.8 title 'on the front'");
    add("edge", "using 1:2 with points linetype 2 pointtype 11 pointsize 1.1 title 'error 0'");
    return plots.empty() ? script + "set label 'nothing to draw' at graph 0.5,0.5 center\nplot NaN notitle\n" : script + plots + "\n";
}

} // namespace

std::string unit_of(const std::string& metric) {
    if (metric == "rmse" || metric == "maximum") return "linear light";
    if (metric == "flip") return "mean, 0 to 1";
    if (metric == "ulp") return "units in the last place";
    return "a fraction";
}

std::string cost_plot(const CostReport& report, const CostCurve& curve, const std::string& metric) {
    Chart chart;
    chart.heading = heading_of(report, curve);
    chart.time = time_axis(curve);
    gather(chart, curve, metric);
    lay_out(chart, 92);
    std::string script = frame(chart, printable(fmt::format("{} ({}): {} against time", curve.knob, curve.meaning, metric)));
    script += fmt::format("set label {} at screen 0.02,{} center rotate\n", gnuplot_quoted(fmt::format("{} ({})", metric, unit_of(metric))),
                          0.5 * (chart.area.low.y + chart.area.high.y) / kHeight);
    return run_gnuplot(script + tics('x', chart.time, chart.area.high.x - chart.area.low.x, 50) +
                       tics('y', chart.error, chart.area.high.y - chart.area.low.y, 36) + names_of_dots(chart) + drawn(chart));
}

// A row a setting: the pictures are equal, so that there is no error to draw.
std::string time_plot(const CostReport& report, const CostCurve& curve) {
    Chart chart;
    chart.heading = heading_of(report, curve);
    const bool equal = std::ranges::all_of(curve.points, [](const CostPoint& p) {
        const auto most = p.errors.find("maximum");
        return most == p.errors.end() || most->second == 0;
    });
    chart.heading.emplace_back(equal ? "the pictures are equal: only time differs" : "NOT ALL PICTURES ARE EQUAL, as they should be");
    chart.time = time_axis(curve);
    const double rows = static_cast<double>(curve.points.size());
    chart.error = {-0.7, std::max(rows, 1.0) - 0.3, false};
    std::string names;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const CostPoint& point = curve.points[i];
        const double row = rows - 1 - static_cast<double>(i);
        if (std::isfinite(point.device_ms)) chart.dots.push_back({&point, row, !point.pareto.empty(), false});
        const std::string name = shortened(printable(point.value), 28);
        longest = std::max(longest, letters(name));
        names += fmt::format("{}{} {}", i ? "," : "", gnuplot_quoted(name), row);
    }
    lay_out(chart, 40 + kLetterWidth * 1.2 * static_cast<double>(longest));
    std::string script = frame(chart, printable(fmt::format("{} ({}): time", curve.knob, curve.meaning)));
    return run_gnuplot(script + tics('x', chart.time, chart.area.high.x - chart.area.low.x, 50) + fmt::format("set ytics ({})\n", names) +
                       drawn(chart));
}

} // namespace lightbench
