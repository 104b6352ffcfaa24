// What `lightbench plot` can draw: a table of kinds and their parameters, and the door that makes a plot from what was typed.
#pragma once

#include "measure/plot.h"
#include "scene/problem.h"

#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

namespace lightbench {

struct PlotParameter {
    std::string_view name;
    std::string_view usual;                   // its value where none is typed; several with commas between
    double min = 0, max = 0;                  // inclusive
    unsigned most = 1;                        // how many values it takes
    bool whole = false;                       // whole numbers only
    std::string_view meaning;                 // with its unit
    std::vector<std::string_view> words = {}; // one of these instead of a number; its value is its place
    std::string_view only = {};               // "over=distance": the word of another parameter without which it means nothing
    double step = 0;                          // values are rounded up to a multiple of it; 0: they stay
};

// Checked: as typed, else the usual ones.
using PlotValues = std::map<std::string_view, std::vector<double>>;

struct PlotKind {
    std::string_view name, description;
    std::span<const PlotParameter> parameters;
    Plot (*make)(const PlotValues&);
};

std::span<const PlotKind> plot_kinds();

// As typed, `--param k=v` in order. Problems name `plot KIND`: an unknown kind or parameter (with the nearest name), one given twice, a value
// that is none or out of range.
std::variant<Plot, Problems> make_plot(std::string_view kind, const std::vector<std::pair<std::string, std::string>>& arguments);

Plot brdf_plot(const PlotValues&);        // incidence, shininess, roughness, index, scale
Plot fresnel_plot(const PlotValues&);     // index, side
Plot attenuation_plot(const PlotValues&); // d0, from, to
Plot form_factor_plot(const PlotValues&); // over, side, distance, resolution, from, to

} // namespace lightbench
