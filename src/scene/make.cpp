// The table of procedural scenes, and the check of what was typed against it.
#include "scene/make.h"

#include "scene/limits.h"
#include "scene/make_kinds.h"
#include "scene/nearest.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>

namespace lightbench {
namespace {

constexpr double kSpheresMax = static_cast<double>(limits::kMaxObjects - 1); // and the floor
constexpr double kLightsMax = 65536;
constexpr double kMeshMax = 50e6;

constexpr MakeParameter kSphereflake[] = {{"depth", 4, 0, 6, true, "generations of children, nine to a ball: (9^(depth+1) - 1) / 8 spheres",
                                           "depth 7 has 5 380 840 spheres, and a scene holds at most 4 194 304 objects"}};
constexpr MakeParameter kCornellBox[] = {
    {"point_light", 1, 0, 1, true, "1: a light below the lamp for methods without area lights, and the ambient term; 0: the lamp alone"}};
constexpr MakeParameter kCorrugated[] = {{"ridges", 12, 2, 1000, true, "ridges of the sheet"},
                                         {"slope", 40, 1, 80, false, "degrees, of each side against the horizontal"},
                                         {"subdivide", 1, 1, 64, true, "strips a side is cut into; 1: the failure, 2 and more: the cure"}};
constexpr MakeParameter kHighlight[] = {
    {"subdivide", 0, 0, 8, true, "times the triangle is quartered; 0: the highlight is lost, 4: it is back"},
    {"shininess", 60, 1, 1000, false, "Phong exponent"}};
constexpr MakeParameter kMachBand[] = {{"facets", 8, 3, 1000, true, "facets of the half cylinder"}};
constexpr MakeParameter kCrease[] = {{"crease", 30, 0, 180, false, "degrees, crease angle of the objects on the right"},
                                     {"left", 180, 0, 180, false, "degrees, of those on the left; 180 smooths over every edge"}};
constexpr MakeParameter kQuads[] = {{"turn", 0, 0, 90, false, "degrees, by which each quad is turned"}};
constexpr MakeParameter kSpheres[] = {
    {"n", 1000, 1, kSpheresMax, true, "spheres in a cubic grid", "a scene holds at most 4 194 304 objects"}};
constexpr MakeParameter kMirrors[] = {
    {"length", 12, 2, 1000, false, "metres, of the corridor"},
    {"reflection", 0.85, 0, 1, false, "of the two mirrors; 1 loses nothing, so that only the depth limit ends a ray"}};
constexpr MakeParameter kRoom[] = {{"furnished", 1, 0, 1, true, "1: a table and a shelf of boxes stand in it; 0: empty, for closed forms"},
                                   {"reflectance", 0.6, 0, 0.99, false, "diffuse, of the white surfaces"}};
constexpr MakeParameter kLights[] = {
    {"n", 100, 1, kLightsMax, true, "point lights", "with more than 65 536 no picture ends in reasonable time"},
    {"objects", 64, 1, 10000, true, "objects below them"}};
constexpr MakeParameter kMesh[] = {{"triangles", 1e6, 12, kMeshMax, true, "about as many; exactly 12 k^2 for a whole k",
                                    "50 000 000 fill a PLY file of 1 GiB, the most that is read"},
                                   {"bumps", 9, 0, 100, true, "waves around the body; 0: a sphere"}};

constexpr MakeParameter kTeapot[] = {{"pieces", 16, 1, 128, true, "that each side of a patch is cut into"},
                                     {"environment", 1, 0, 1, false, "weight of environment mapping; 1: chrome"}};
constexpr MakeParameter kMetals[] = {{"rows", 4, 1, 16, true, "roughnesses, a shelf each, smooth ones above"},
                                     {"smoothest", 0.1, 0.001, 10, false, "rms slope m of the upper shelf"},
                                     {"roughest", 0.5, 0.001, 10, false, "of the lowest; those between in equal ratios"}};
constexpr MakeParameter kPanes[] = {
    {"n", 1000, 1, 100000, true, "panes that all overlap in the middle, listed out of order", "no picture of more ends in reasonable time"},
    {"opacity", 0.04, 0, 1, false, "of each pane, in the channels that it colors; half of it in the others"},
    {"tilt", 0, 0, 80, false, "degrees, by which panes lean at most, each its own way; above 0 they intersect"}};

constexpr MakeKind kKinds[] = {
    {"sphereflake", "balls on balls, nine to each, a third in size (Haines 1987, SPD `balls`)", kSphereflake, make_sphereflake},
    {"primitives", "one of each shape on a floor, three lights", {}, make_primitives},
    {"cornell-box", "the measured box of Cornell University: geometry, reflectances, camera", kCornellBox, make_cornell_box},
    {"corrugated", "a regular corrugated sheet: all averaged normals are parallel, so Gouraud and Phong show it flat", kCorrugated,
     make_corrugated},
    {"highlight", "a highlight in the middle of one large triangle: Gouraud loses it", kHighlight, make_highlight},
    {"mach-band", "a faceted half cylinder and an intensity ramp: bands at every edge and kink", kMachBand, make_mach_band},
    {"crease", "bodies with sharp edges, smoothed over them (left) and not (right)", kCrease, make_crease},
    {"quads", "one quad split along either diagonal and along scan lines, for Gouraud shading", kQuads, make_quads},
    {"spheres", "a cubic grid of n spheres", kSpheres, make_spheres},
    {"mirrors", "a corridor between two facing mirrors", kMirrors, make_mirrors},
    {"room", "a closed, diffuse room with a lamp, seen from inside", kRoom, make_room},
    {"lights", "n coloured point lights over a field of objects", kLights, make_lights},
    {"mesh", "one closed bumpy mesh of about so many triangles", kMesh, make_mesh},
    {"teapot", "Newell's teapot (1975): 32 Bezier patches, of chrome", kTeapot, make_teapot},
    {"metals", "copper, gold, silver and aluminium of Cook-Torrance (left of each pair) beside Phong, smooth to rough", kMetals,
     make_metals},
    {"panes", "n translucent panes behind each other, a spiral of petals, out of order", kPanes, make_panes},
};

template <typename Rows> std::vector<std::string_view> names_of(const Rows& rows) {
    std::vector<std::string_view> names;
    for (const auto& row : rows) names.push_back(row.name);
    return names;
}

std::optional<double> parse_number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string range_of(const MakeParameter& p) {
    return fmt::format("a {} from {} to {}{}{}{}", p.integer ? "whole number" : "number", p.min, p.max, p.limit.empty() ? "" : " (",
                       p.limit, p.limit.empty() ? "" : ")");
}

// Reads one `k=v` into `values`; says what is wrong with it, if anything.
std::optional<std::string> read_argument(std::span<const MakeParameter> parameters, const std::pair<std::string, std::string>& argument,
                                         std::vector<std::optional<double>>& values) {
    const auto& [name, text] = argument;
    const auto p = std::find_if(parameters.begin(), parameters.end(), [&](const MakeParameter& row) { return row.name == name; });
    if (p == parameters.end()) return fmt::format("unknown parameter \"{}\"{}", name, suggestion(name, names_of(parameters)));
    auto& value = values[static_cast<std::size_t>(p - parameters.begin())];
    if (value) return fmt::format("parameter \"{}\" is given twice; once is right", name);
    const auto number = parse_number(text);
    const bool good = number && *number >= p->min && *number <= p->max && (!p->integer || std::floor(*number) == *number);
    value = good ? *number : p->default_value;
    if (!good) return fmt::format("parameter \"{}\" is {}; it must be {}", name, text.empty() ? "empty" : text, range_of(*p));
    return std::nullopt;
}

} // namespace

double MakeValues::operator[](std::string_view name) const {
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (parameters[i].name == name) return values[i];
    fmt::print(stderr, "CHECK failed: this kind has no parameter \"{}\"\n", name);
    std::abort();
}

std::size_t MakeValues::count(std::string_view name) const {
    return static_cast<std::size_t>((*this)[name]);
}

std::span<const MakeKind> make_kinds() {
    return kKinds;
}

std::variant<Scene, Problems> make_scene(std::string_view kind_name, const MakeArguments& arguments) {
    const auto kind = std::find_if(std::begin(kKinds), std::end(kKinds), [&](const MakeKind& row) { return row.name == kind_name; });
    if (kind == std::end(kKinds))
        return Problems{{"make", 0, 0, fmt::format("unknown kind \"{}\"{}", kind_name, suggestion(kind_name, names_of(kKinds)))}};
    Problems problems;
    std::vector<std::optional<double>> typed(kind->parameters.size());
    for (const auto& argument : arguments)
        if (const auto text = read_argument(kind->parameters, argument, typed))
            problems.push_back({fmt::format("make {}", kind_name), 0, 0, *text});
    if (!problems.empty()) return problems;
    MakeValues values{kind->parameters, {}};
    for (std::size_t i = 0; i < typed.size(); ++i) values.values.push_back(typed[i].value_or(kind->parameters[i].default_value));
    Scene scene = kind->build(values);
    scene.name = kind_name;
    return scene;
}

} // namespace lightbench
