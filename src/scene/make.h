// Procedural scenes: a table of kinds and their parameters, and the door that builds one. In: a name and `k=v` pairs as typed. Out: a Scene.
#pragma once

#include "scene/problem.h"
#include "scene/scene.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lightbench {

struct MakeParameter {
    std::string_view name;
    double default_value;
    double min, max;             // inclusive
    bool integer;                // whole numbers only
    std::string_view meaning;    // with its unit
    std::string_view limit = {}; // why max is what it is, where a limit of the program sets it
};

// The parameters of one call, checked: as typed, else their defaults.
struct MakeValues {
    std::span<const MakeParameter> parameters;
    std::vector<double> values;                     // one a parameter
    double operator[](std::string_view name) const; // aborts on a name that the kind does not have: our bug
    std::size_t count(std::string_view name) const; // of a parameter that is a whole number >= 0
};

struct MakeKind {
    std::string_view name;
    std::string_view description;
    std::span<const MakeParameter> parameters;
    Scene (*build)(const MakeValues&);
};

// Every kind, in the order of `make --list`.
std::span<const MakeKind> make_kinds();

// As typed: `--param k=v`, in order. A name given twice is a problem.
using MakeArguments = std::vector<std::pair<std::string, std::string>>;

// Problems name `make KIND` as their file: an unknown kind or parameter (with the nearest name), a value that is no number or out of range.
// The same kind and arguments give the same scene, bit for bit.
std::variant<Scene, Problems> make_scene(std::string_view kind, const MakeArguments& arguments);

} // namespace lightbench
