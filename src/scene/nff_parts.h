// What the parts of the NFF loader share: one load in progress and the readers of its statements. Only nff*.cpp include this.
#pragma once

#include "scene/limits.h"
#include "scene/nff_scan.h"
#include "scene/problem_log.h"
#include "scene/scene.h"

#include <array>
#include <fmt/format.h>
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
    std::array<double, 8> fill{};                         // the last `f`
    std::map<std::array<double, 8>, std::uint32_t> fills; // -> material
    std::optional<std::uint32_t> material;
    std::vector<std::size_t> plain_lights; // without a color of their own
    NffCount without_area, cut, without_normals;
    unsigned word_line = 0, word_column = 0; // of the statement that is being read
    unsigned last_line = 0, last_column = 0; // of the last number that was read
    bool stopped = false;                    // a limit was passed
};

// A number of a statement, as messages name it, and what it may be.
struct NffField {
    std::string_view name;
    double low = -limits::kMaxCoordinate, high = limits::kMaxCoordinate;
    std::string_view text = "it must lie between -1e15 and 1e15 (limit kMaxCoordinate)";
};

inline constexpr std::string_view kNffFraction = "it must lie between 0 and 1";
inline constexpr std::string_view kNffNotNegative = "it must be 0 or greater, and at most 3.4e38";

// A problem at a place. Its text is only made if it is listed: a file of five million wrong lines is refused in no time.
template <class... Args> void fault_at(NffLoad& load, unsigned line, unsigned column, fmt::format_string<Args...> text, Args&&... args) {
    if (full(load.log))
        ++load.log.unlisted;
    else
        report(load.log, load.file, line, column, fmt::format(text, std::forward<Args>(args)...));
}
template <class... Args> void fault_here(NffLoad& load, fmt::format_string<Args...> text, Args&&... args) {
    fault_at(load, load.in.line, load.in.column(), text, std::forward<Args>(args)...);
}
template <class... Args> void fault_word(NffLoad& load, fmt::format_string<Args...> text, Args&&... args) {
    fault_at(load, load.word_line, load.word_column, text, std::forward<Args>(args)...);
}
template <class... Args> void fault_last(NffLoad& load, fmt::format_string<Args...> text, Args&&... args) {
    fault_at(load, load.last_line, load.last_column, text, std::forward<Args>(args)...);
}

// The numbers of a statement in order, over line ends if need be. False, and reported, at the first that is missing or is no number; one
// that is out of its range is reported and read on, and makes the result false too.
bool read_numbers(NffLoad& load, std::string_view statement, std::span<const NffField> fields, std::span<double> out);

// After a statement: reports what else stands on its line; if it was not `good`, leaves out the numbers that it still holds.
void end_statement(NffLoad& load, std::string_view statement, bool good);

void read_view(NffLoad& load);                       // v
bool read_polygon(NffLoad& load, bool with_normals); // p, pp
void add_object(NffLoad& load, Shape shape);

} // namespace lightbench
