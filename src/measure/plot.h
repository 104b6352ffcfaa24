// Curves of functions, as `lightbench plot` draws them. In: points. Out: CSV, or an SVG that gnuplot draws.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lightbench {

struct PlotLine {
    std::string name;
    std::vector<glm::dvec2> points;
    unsigned color = 1, dash = 1; // numbers of gnuplot_style() and of gnuplot's dash types; of marks, dash 1: circles, 2: triangles
    bool marks = false;           // points instead of a line
};

struct Plot {
    std::string title;
    std::vector<std::string> notes; // what the formulas are and whose
    std::string x_key, y_key;       // columns of the CSV
    std::string x_label, y_label;
    bool log_x = false, log_y = false;
    bool polar = false;       // x: degrees from the normal, to the right; y: the radius
    std::vector<double> rays; // polar only: angles on the left from which light comes
    std::vector<PlotLine> lines;
};

// Header `curve,X,Y`, then a line a point; numbers in the fewest digits that read back as the same.
std::string plot_csv(const Plot& plot);

// Throws gpu::EnvironmentError if gnuplot cannot draw.
std::string plot_svg(const Plot& plot);

} // namespace lightbench
