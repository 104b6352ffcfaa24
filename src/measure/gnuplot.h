// Pictures drawn by gnuplot, which runs as a child of its own with a time limit. In: a script. Out: an SVG file's text.
#pragma once

#include <string>

namespace lightbench {

// What every picture has in common: an SVG terminal of this size on white, UTF-8, the colors of `linetype 1` to 8 (Okabe and Ito 2008,
// "Color universal design": told apart by the color-blind), a light grid.
std::string gnuplot_style(unsigned width, unsigned height);

bool has_gnuplot(); // it can be run

// The script writes to standard output, where the SVG is taken from. No shell, no start-up files of the user.
// Throws gpu::EnvironmentError if gnuplot is not there, takes more than 30 s or complains.
std::string run_gnuplot(const std::string& script);

} // namespace lightbench
