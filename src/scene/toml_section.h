// Typed reading of one TOML table: each reader takes a key's value if it is there, checks it, and reports what is wrong with its line and
// column. In: a table and the rules of its keys. Out: plain values, problems; at the end, the keys that nobody asked for.
#pragma once

#include "scene/limits.h"
#include "scene/problem_log.h"
#include "scene/toml_library.h"

#include <cfloat>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

// What a number may be; `text` completes "opacity is 1.7; ...".
struct Rule {
    double low, high;
    bool low_excluded, high_excluded;
    std::string_view text;
};

inline constexpr double kLargestFloat = FLT_MAX;
inline constexpr Rule kCoordinate{-limits::kMaxCoordinate, limits::kMaxCoordinate, false, false,
                                  "it must lie between -1e15 and 1e15 (limit kMaxCoordinate)"};
inline constexpr Rule kLength{0, limits::kMaxCoordinate, true, false, "it must be greater than 0 and at most 1e15 (limit kMaxCoordinate)"};
inline constexpr Rule kFraction{0, 1, false, false, "it must lie between 0 and 1"};
inline constexpr Rule kNotNegative{0, kLargestFloat, false, false, "it must be 0 or greater, and at most 3.4e38"};
inline constexpr Rule kAnyFloat{-kLargestFloat, kLargestFloat, false, false, "it must lie between -3.4e38 and 3.4e38"};
inline constexpr Rule kPositive{0, kLargestFloat, true, false, "it must be greater than 0, and at most 3.4e38"};

struct Section {
    const toml::table* table = nullptr;
    std::string who; // begins every message: `material "pane"`
    std::string_view file;
    ProblemLog* log = nullptr;
    std::vector<std::string_view> known; // keys that were asked for
};

void fault(const Section& section, const toml::source_region& where, std::string_view text);
void fault(const Section& section, const toml::node& where, std::string_view text);

// Where a key is told about that may be absent: at its value, or else at the head of its section.
const toml::source_region& place_of(const Section& section, std::string_view key);

// The value of a key, or null; either way the key is known from now on.
const toml::node* find(Section& section, std::string_view key);

// Each returns true if the key is there and its value is right; only then is `out` written. `key` names the value in messages.
bool read(Section& section, std::string_view key, double& out, const Rule& rule);
bool read(Section& section, std::string_view key, float& out, const Rule& rule);
bool read(Section& section, std::string_view key, bool& out);
bool read(Section& section, std::string_view key, std::string& out);
bool read_name(Section& section, std::string_view key, std::string& out); // a string that can be printed
bool read_whole(Section& section, std::string_view key, unsigned& out, unsigned low, unsigned high);
bool read_color(Section& section, std::string_view key, glm::vec3& out, const Rule& rule);   // a number, or [r, g, b]
bool read_vector(Section& section, std::string_view key, glm::dvec3& out, const Rule& rule); // [x, y, z]
bool read_pair(Section& section, std::string_view key, glm::dvec2& out, const Rule& rule);   // a number for both, or [u, v]

// Index of the word among `words`, or npos with a problem that lists them.
std::size_t read_choice(Section& section, std::string_view key, std::span<const std::string_view> words);

// The same for a value that has no key of its own, such as a point in a list.
bool vector_of(const Section& section, const toml::node& node, std::string_view name, glm::dvec3& out, const Rule& rule);

// "a string", "a whole number" ...: what a node is, for messages.
std::string_view kind_name(const toml::node& node);

void report_unknown_keys(const Section& section);

} // namespace lightbench
