// What the parts of the NFF loader share: one load in progress and the readers of its statements. Only nff*.cpp include this.
#pragma once

#include "scene/limits.h"
#include "scene/nff_scan.h"
#include "scene/problem_log.h"
#include "scene/scene.h"

#include <array>
#include <map>
#include <span>
#include <string>

namespace lightbench {

// Polygons that were not taken as they are: how many, and where the first one is.
struct NffCount {
    std::size_t count = 0;
    unsigned first_line = 0;
};

struct NffLoad {
    std::string file;
    NffScanner in;
    ProblemLog log;
    Scene scene;
    std::array<double, 8> fill{};                            // the last `f`
    std::map<std::array<double, 8>, std::uint32_t> fills;    // -> material
    std::optional<std::uint32_t> material;
    std::vector<std::size_t> plain_lights;                   // without a color of their own
    NffCount without_area, cut, without_normals;
    bool stopped = false;                                    // a limit was passed
};

// A number of a statement, as messages name it, and what it may be.
struct NffField {
    std::string_view name;
    double low = -limits::kMaxCoordinate, high = limits::kMaxCoordinate;
    std::string_view text = "it must lie between -1e15 and 1e15 (limit kMaxCoordinate)";
};

inline constexpr std::string_view kNffFraction = "it must lie between 0 and 1";
inline constexpr std::string_view kNffNotNegative = "it must be 0 or greater, and at most 3.4e38";

void fault_here(NffLoad& load, std::string_view text);                       // at the scanner
void fault_at(NffLoad& load, unsigned line, unsigned column, std::string_view text);

// The numbers of a statement in order, over line ends if need be. False, and reported, at the first that is missing or is no number; one
// that is out of its range is reported and read on, and makes the result false too.
bool read_numbers(NffLoad& load, std::string_view statement, std::span<const NffField> fields, std::span<double> out);

// After a statement: reports what else stands on its line; if it was not `good`, leaves out the numbers that it still holds.
void end_statement(NffLoad& load, std::string_view statement, bool good);

void read_view(NffLoad& load, unsigned line, unsigned column);               // v
bool read_polygon(NffLoad& load, bool with_normals);                         // p, pp
void add_object(NffLoad& load, Shape shape);

} // namespace lightbench
