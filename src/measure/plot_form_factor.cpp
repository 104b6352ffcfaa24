// Form factors by a hemi-cube on the host (SPEC S28) beside closed forms: what its resolution and the distance do to it.
#include "measure/plot_kinds.h"
#include "radiosity/form_factors.h"

#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

// Seen from the origin, normal +z.
struct Square {
    const char* name;
    glm::dvec3 corner, u, v; // edges, at right angles
};

Square parallel_square(double side, double distance) {
    return {"parallel", {-side / 2, -side / 2, distance}, {0, side, 0}, {side, 0, 0}};
}

// Stands on the plane of the point.
Square perpendicular_square(double side, double distance) {
    return {"perpendicular", {distance, side / 2, 0}, {0, -side, 0}, {0, 0, side}};
}

double closed_form(const Square& s) {
    const std::vector<glm::dvec3> corners = {s.corner, s.corner + s.u, s.corner + s.u + s.v, s.corner + s.v};
    return point_to_polygon(glm::dvec3(0), glm::dvec3(0, 0, 1), corners);
}

bool sees(const Square& s, const glm::dvec3& direction) {
    const glm::dvec3 normal = glm::cross(s.u, s.v);
    const double towards = glm::dot(direction, normal);
    if (towards == 0) return false;
    const double t = glm::dot(s.corner, normal) / towards;
    const glm::dvec3 at = t * direction - s.corner;
    const double a = glm::dot(at, s.u) / glm::dot(s.u, s.u), b = glm::dot(at, s.v) / glm::dot(s.v, s.v);
    return t > 0 && a >= 0 && a < 1 && b >= 0 && b < 1;
}

// Delta form factors of the pixels whose centers see the square. Cohen and Greenberg 1985, "The hemi-cube: a radiosity solution for complex
// environments", sec. 4.
double by_hemicube(const Square& s, unsigned n, const DeltaFormFactors& table) {
    const auto center = [&](unsigned i) { return -1 + (2.0 * i + 1) / n; };
    double sum = 0;
    for (unsigned j = 0; j < n; ++j)
        for (unsigned i = 0; i < n; ++i)
            if (sees(s, {center(i), center(j), 1})) sum += table.top[std::size_t{j} * n + i];
    for (unsigned j = 0; j < n / 2; ++j)
        for (unsigned i = 0; i < n; ++i) {
            const double y = center(i), z = (2.0 * j + 1) / n;
            for (const glm::dvec3& direction : {glm::dvec3(1, y, z), glm::dvec3(-1, y, z), glm::dvec3(y, 1, z), glm::dvec3(y, -1, z)})
                if (sees(s, direction)) sum += table.side[std::size_t{j} * n + i];
        }
    return sum;
}

unsigned even(double n) {
    return 2 * static_cast<unsigned>(std::ceil(n / 2));
}

// Sideways, by up to a tenth of its side: the golden ratio and its square in two directions spread them evenly (Roberts 2018, "The
// unreasonable effectiveness of quasirandom sequences").
Square moved(Square s, unsigned step) {
    const double a = std::fmod(0.5 + 0.7548776662466927 * step, 1), b = std::fmod(0.5 + 0.5698402909980532 * step, 1);
    s.corner += (0.2 * a - 0.1) * s.u + glm::dvec3((0.2 * b - 0.1) * glm::length(s.u), 0, 0);
    return s;
}

// Root mean square over positions: of a single one it may be anything down to 0.
double relative_error(const Square& s, unsigned n, const DeltaFormFactors& table) {
    constexpr unsigned kPositions = 16;
    double sum = 0;
    for (unsigned i = 0; i < kPositions; ++i) {
        const Square at = moved(s, i);
        const double error = by_hemicube(at, n, table) / closed_form(at) - 1;
        sum += error * error;
    }
    return std::sqrt(sum / kPositions);
}

Plot over_resolution(const PlotValues& values) {
    const double side = values.at("side")[0], distance = values.at("distance")[0];
    Plot plot;
    plot.title = fmt::format("Hemi-cube against closed form: squares of {:g} m at {:g} m", side, distance);
    plot.notes = {
        "Error of the summed delta form factors from a point to a square (Cohen and Greenberg 1985) against Lambert 1760.",
        "Root mean square over 16 positions of the square. Its edges lie along the rows of pixels, which are in or out as a whole."};
    plot.x_key = "resolution", plot.y_key = "relative_error";
    plot.x_label = "pixels a side of the hemi-cube", plot.y_label = "relative error";
    plot.log_x = plot.log_y = true;
    const Square squares[] = {parallel_square(side, distance), perpendicular_square(side, distance)};
    for (const Square& s : squares)
        plot.lines.push_back(
            {fmt::format("{}, form factor {:.5g}", s.name, closed_form(s)), {}, static_cast<unsigned>(plot.lines.size() + 1)});
    unsigned last = 0;
    for (double wish = 8; even(wish) <= values.at("largest")[0]; wish *= 1.25) {
        const unsigned n = even(wish);
        if (n == last) continue;
        last = n;
        const DeltaFormFactors table = exact_delta_form_factors(n);
        for (std::size_t i = 0; i < 2; ++i) plot.lines[i].points.emplace_back(n, relative_error(squares[i], n, table));
    }
    return plot;
}

void add_distances(Plot& plot, double side, const std::vector<double>& resolutions, Square (*place)(double, double), unsigned color) {
    constexpr int kCloses = 200, kMarks = 40;
    const auto at = [](int i, int count) { return 0.05 * std::pow(200.0, static_cast<double>(i) / count); }; // 0.05 to 10 sides
    PlotLine closed{fmt::format("{}: closed form from its center", place(1, 1).name), {}, color};
    for (int i = 0; i <= kCloses; ++i) closed.points.emplace_back(at(i, kCloses) * side, closed_form(place(side, at(i, kCloses) * side)));
    plot.lines.push_back(closed);
    unsigned dash = 0;
    for (const double resolution : resolutions) {
        const unsigned n = even(resolution);
        const DeltaFormFactors table = exact_delta_form_factors(n);
        PlotLine marks{fmt::format("{}: hemi-cube of {} pixels", place(1, 1).name, n), {}, color, ++dash, true};
        for (int i = 0; i <= kMarks; ++i)
            marks.points.emplace_back(at(i, kMarks) * side, by_hemicube(place(side, at(i, kMarks) * side), n, table));
        plot.lines.push_back(marks);
    }
}

Plot over_distance(const PlotValues& values) {
    const double side = values.at("side")[0];
    Plot plot;
    plot.title = fmt::format("Form factors of squares of {:g} m by hemi-cube and in closed form", side);
    plot.notes = {"From the center of a patch (Cohen and Greenberg 1985, Lambert 1760), and between two squares (Howell's catalog C-11).",
                  "Far away few pixels see the square; near by, the center does not stand for the whole patch."};
    plot.x_key = "distance_m", plot.y_key = "form_factor";
    plot.x_label = "distance in meters", plot.y_label = "form factor";
    plot.log_x = plot.log_y = true;
    add_distances(plot, side, values.at("resolution"), parallel_square, 1);
    add_distances(plot, side, values.at("resolution"), perpendicular_square, 2);
    PlotLine whole{"parallel: closed form between squares", {}, 7, 2};
    for (const glm::dvec2& p : plot.lines[0].points) whole.points.emplace_back(p.x, parallel_rectangles(side, side, p.x));
    plot.lines.push_back(whole);
    return plot;
}

} // namespace

Plot form_factor_plot(const PlotValues& values) {
    return values.at("over")[0] == 0 ? over_resolution(values) : over_distance(values);
}

} // namespace lightbench
