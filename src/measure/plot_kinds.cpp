#include "measure/plot_kinds.h"

#include "scene/nearest.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <set>

namespace lightbench {
namespace {

const PlotParameter kBrdf[] = {{"incidence", "45", 0, 89.9, 4, false, "degrees between the light and the normal"},
                               {"shininess", "20", 0, 1e6, 3, false, "Phong's exponent n"},
                               {"roughness", "0.2", 1e-3, 10, 3, false, "rms slope m of Cook-Torrance's facets"},
                               {"index", "1.5", 1.0001, 1e3, 1, false, "index of refraction of Cook-Torrance's facets"},
                               {"scale", "largest", 0, 0, 1, false, "each lobe over its largest value, or as it is", {"largest", "none"}}};
const PlotParameter kFresnel[] = {{"index", "1.5", 0.01, 1e3, 4, false, "index of refraction of the dielectric"},
                                  {"side",
                                   "both",
                                   0,
                                   0,
                                   1,
                                   false,
                                   "from which the light comes; inside, it is reflected totally beyond the critical angle",
                                   {"outside", "inside", "both"}}};
const PlotParameter kAttenuation[] = {{"d0", "0.5,1,2", 1e-6, 1e6, 4, false, "meters, offset of the linear law"},
                                      {"from", "0.05", 1e-6, 1e6, 1, false, "meters, the nearest distance"},
                                      {"to", "20", 1e-6, 1e6, 1, false, "meters, the farthest"}};
const PlotParameter kFormFactor[] = {
    {"over", "resolution", 0, 0, 1, false, "what varies", {"resolution", "distance"}},
    {"side", "1", 1e-3, 1e3, 1, false, "meters, of the squares"},
    {"distance", "1", 1e-3, 1e3, 1, false, "meters to the squares", {}, "over=resolution"},
    {"resolution", "50", 2, 1024, 2, true, "pixels a side of the hemi-cube; odd ones are rounded up", {}, "over=distance", 2},
    {"largest", "256", 16, 1024, 1, true, "largest resolution", {}, "over=resolution"}};

const PlotKind kKinds[] = {
    {"brdf", "specular lobes of Phong beside Cook-Torrance with both distributions, in the plane of incidence", kBrdf, brdf_plot},
    {"fresnel", "reflectance of a dielectric: both polarizations and their mean", kFresnel, fresnel_plot},
    {"attenuation", "the three laws by which light thins out with distance", kAttenuation, attenuation_plot},
    {"form-factor", "a parallel and a perpendicular square by hemi-cube against closed form", kFormFactor, form_factor_plot}};

template <class Rows> std::vector<std::string_view> names_of(const Rows& rows) {
    std::vector<std::string_view> names;
    for (const auto& row : rows) names.push_back(row.name);
    return names;
}

std::optional<double> parse_value(const PlotParameter& p, std::string_view text) {
    if (!p.words.empty()) {
        const auto word = std::find(p.words.begin(), p.words.end(), text);
        return word == p.words.end() ? std::nullopt : std::optional<double>(word - p.words.begin());
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc() && end == text.data() + text.size() && value >= p.min && value <= p.max; // false for NaN
    return number && (!p.whole || std::floor(value) == value) ? std::optional(value) : std::nullopt;
}

// Nothing if one of them is wrong, or there are too many.
std::optional<std::vector<double>> parse_values(const PlotParameter& p, std::string_view text) {
    std::vector<double> values;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const auto value = parse_value(p, text.substr(at, comma - at));
        if (!value || values.size() == p.most) return std::nullopt;
        values.push_back(*value);
        at = comma + 1;
    }
    return values;
}

std::string wanted(const PlotParameter& p) {
    if (!p.words.empty()) return fmt::format("it must be {}", fmt::join(p.words, " or "));
    const char* what = p.whole ? "whole number" : "number";
    if (p.most == 1) return fmt::format("it must be a {} from {} to {}", what, p.min, p.max);
    return fmt::format("it must be one to {} {}s from {} to {}, with commas between", p.most, what, p.min, p.max);
}

std::optional<std::string> read_argument(const PlotKind& kind, const std::pair<std::string, std::string>& argument, PlotValues& typed) {
    const auto& [name, text] = argument;
    const auto p = std::find_if(kind.parameters.begin(), kind.parameters.end(), [&](const PlotParameter& row) { return row.name == name; });
    if (p == kind.parameters.end()) return fmt::format("unknown parameter \"{}\"{}", name, suggestion(name, names_of(kind.parameters)));
    if (typed.contains(p->name)) return fmt::format("parameter \"{}\" is given twice; once is right", name);
    auto values = parse_values(*p, text);
    if (values && p->step > 0)
        for (double& value : *values) value = p->step * std::ceil(value / p->step);
    if (values && std::set<double>(values->begin(), values->end()).size() < values->size())
        return fmt::format("parameter \"{}\" is \"{}\": two curves would be the same", name, text);
    typed[p->name] = values.value_or(std::vector<double>());
    return values ? std::nullopt : std::optional(fmt::format("parameter \"{}\" is \"{}\"; {}", name, text, wanted(*p)));
}

// "over=distance": the word that was typed there, or the usual one.
bool is_met(const PlotKind& kind, std::string_view condition, const PlotValues& values) {
    const std::string_view name = condition.substr(0, condition.find('=')), word = condition.substr(name.size() + 1);
    const auto p = std::find_if(kind.parameters.begin(), kind.parameters.end(), [&](const PlotParameter& row) { return row.name == name; });
    const auto& chosen = values.at(name);
    return chosen.empty() || p->words[static_cast<std::size_t>(chosen[0])] == word;
}

// Parameters that were typed and mean nothing beside the others.
void check_conditions(const PlotKind& kind, const PlotValues& typed, const PlotValues& values, const std::string& where,
                      Problems& problems) {
    for (const PlotParameter& p : kind.parameters)
        if (typed.contains(p.name) && !p.only.empty() && !is_met(kind, p.only, values))
            problems.push_back({where, 0, 0, fmt::format("parameter \"{}\" belongs to {}", p.name, p.only)});
}

} // namespace

std::span<const PlotKind> plot_kinds() {
    return kKinds;
}

std::variant<Plot, Problems> make_plot(std::string_view name, const std::vector<std::pair<std::string, std::string>>& arguments) {
    const auto kind = std::find_if(std::begin(kKinds), std::end(kKinds), [&](const PlotKind& row) { return row.name == name; });
    if (kind == std::end(kKinds))
        return Problems{{"plot", 0, 0, fmt::format("unknown kind \"{}\"{}", name, suggestion(name, names_of(kKinds)))}};
    const std::string where = fmt::format("plot {}", name);
    Problems problems;
    PlotValues values;
    for (const auto& argument : arguments)
        if (const auto text = read_argument(*kind, argument, values)) problems.push_back({where, 0, 0, *text});
    const PlotValues typed = values;
    for (const PlotParameter& p : kind->parameters) values.try_emplace(p.name, *parse_values(p, p.usual));
    if (problems.empty() && values.contains("from") && values["from"][0] >= values["to"][0])
        problems.push_back(
            {where, 0, 0, fmt::format("from is {} and to is {}; from must be the smaller one", values["from"][0], values["to"][0])});
    check_conditions(*kind, typed, values, where, problems);
    if (!problems.empty()) return problems;
    return kind->make(values);
}

} // namespace lightbench
