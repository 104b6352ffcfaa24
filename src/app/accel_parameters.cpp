#include "app/accel_parameters.h"

#include "app/numbers.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

using Take = bool (*)(std::string_view, Structure, AccelParameters&); // false: not understood

struct ParameterRow {
    std::string_view name, must_be;
    std::vector<Structure> structures;
    Take take;
};

// Leaves of both hierarchies name their primitives in two bits.
bool take_leaf(std::string_view text, Structure structure, AccelParameters& p) {
    const auto n = structure == Structure::octree ? parse_unsigned<65535>(text) : parse_unsigned<4>(text);
    p.leaf = n.value_or(0);
    return p.leaf > 0;
}

bool take_cells(std::string_view text, Structure, AccelParameters& p) {
    const auto parts = split(text, ',');
    if (parts.size() != 3) return false;
    for (int i = 0; i < 3; ++i) p.cells[i] = parse_unsigned<1024>(parts[static_cast<std::size_t>(i)]).value_or(0);
    return p.cells.x > 0 && p.cells.y > 0 && p.cells.z > 0;
}

bool take_density(std::string_view text, Structure, AccelParameters& p) {
    p.density = parse_number<0, 1000>(text).value_or(0);
    return p.density > 0;
}

bool take_depth(std::string_view text, Structure, AccelParameters& p) {
    p.depth = parse_unsigned<20>(text).value_or(0);
    return p.depth > 0;
}

bool take_builder(std::string_view text, Structure, AccelParameters& p) {
    p.builder = text == "device" ? TreeBuilder::device : TreeBuilder::host;
    return text == "device" || text == "host";
}

const std::vector<ParameterRow>& rows() {
    static const std::vector<ParameterRow> all = {
        {"leaf",
         "a number of primitives, 1 to 4 (of an octree: to 65535)",
         {Structure::bvh, Structure::sphere_bvh, Structure::octree},
         take_leaf},
        {"cells", "L,M,N, three whole numbers from 1 to 1024", {Structure::grid}, take_cells},
        {"density", "cells a primitive, above 0 and at most 1000", {Structure::grid}, take_density},
        {"depth", "a whole number from 1 to 20", {Structure::octree}, take_depth},
        {"builder", "host or device", {Structure::bvh}, take_builder},
    };
    return all;
}

const char* name_of(Structure structure) {
    static const char* const names[] = {"none", "bvh", "sphere-bvh", "grid", "octree"};
    return names[static_cast<std::size_t>(structure)];
}

void take(std::string_view text, Structure structure, AccelParameters& parameters, std::vector<std::string>& problems) {
    const std::size_t equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    const auto row = std::ranges::find(rows(), name, &ParameterRow::name);
    if (equals == std::string_view::npos || row == rows().end())
        problems.push_back(fmt::format("\"{}\" must be leaf=N, cells=L,M,N, density=X, depth=N or builder=host|device", text));
    else if (std::ranges::find(row->structures, structure) == row->structures.end())
        problems.push_back(fmt::format("{} has no meaning for --accel {}", name, name_of(structure)));
    else if (!row->take(text.substr(equals + 1), structure, parameters))
        problems.push_back(fmt::format("{}: \"{}\" must be {}", name, text.substr(equals + 1), row->must_be));
}

} // namespace

std::vector<std::string> parse_accel_parameters(std::string_view text, Structure structure, AccelParameters& parameters) {
    std::vector<std::string> assignments, problems;
    for (const std::string_view part : split(text, ','))
        if (assignments.empty() || part.find('=') != std::string_view::npos)
            assignments.emplace_back(part);
        else
            assignments.back() += fmt::format(",{}", part);
    for (const std::string& assignment : assignments) take(assignment, structure, parameters, problems);
    return problems;
}

} // namespace lightbench
