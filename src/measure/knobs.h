// What `lightbench cost` turns: one table. A value of a knob is a change to the options of the command line, so that --budget applies the same
// values as the sweep, and every picture has a command that repeats it. Pure.
#pragma once

#include "measure/report.h"
#include "scene/scene.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

// Options as typed: "--spp" and "16"; switches have an empty text.
using OptionTexts = std::map<std::string, std::string, std::less<>>;

// Where a value stands among those that it is compared with: error falls, or stays, as x grows within a group.
struct Scale {
    std::string group; // "jittered"; may be empty
    double x = 1;      // > 0
};

struct ExpectedSlope {
    std::string_view group, metric;
    std::optional<double> theory; // absent: no single number, and `why` says what is known
    std::string_view why;
    double tolerance = 0;    // what is flatter by more is noted; 0: nothing is
    bool everywhere = false; // it holds of every scene, both ways: what lies outside is a broken expectation
};

struct Knob {
    std::string_view name, meaning;
    std::string_view values;          // what they look like, for people
    std::string_view reference;       // how it is computed, and what tells how sure it is
    std::string_view metric = "rmse"; // that plots show first
    std::string_view method = {};     // --method that it belongs to; empty: any
    std::vector<std::string_view> defaults = {};
    std::vector<std::string> (*defaults_of)(const Scene&) = nullptr; // in their place, where values are lengths
    bool time_only = false;                                          // all pictures must be equal to the reference
    // Options that the sweep sets where the user did not; may be null.
    void (*base)(OptionTexts&, const Scene&) = nullptr;
    // False: not a value of this knob. Numbers are checked by whoever parses options.
    bool (*apply)(std::string_view value, OptionTexts&) = nullptr;
    // From the options of the sweep to those of the reference; `again`: to those of a second one, which tells how sure the first is.
    void (*refer)(OptionTexts&, std::span<const std::string> values, bool again) = nullptr;
    bool in_float64 = false; // the reference is, where the device has it
    // Null: values have no order. `options`: of the point, with the value in them.
    std::optional<Scale> (*scale)(std::string_view value, const OptionTexts& options) = nullptr;
    Errors (*computed)(std::string_view value) = nullptr; // errors that need no picture; null: there are none
    std::string_view axis = {};                           // of Scale::x: "samples a pixel"
    std::vector<ExpectedSlope> slopes = {};
};

// The one that has no pictures and no values: stable formulas against naive ones (function_curves.h). It is no row of the table.
constexpr std::string_view kFunctionsKnob = "functions";

std::span<const Knob> knobs();
const Knob* find_knob(std::string_view name);

// NAME or NAME=v1,v2, as typed.
struct KnobUse {
    const Knob* knob = nullptr;
    std::vector<std::string> values; // none twice; empty: the knob's own
};

// Says what is wrong, and what would be right, in `problem` if it is not understood.
std::optional<KnobUse> parse_knob(std::string_view text, std::string& problem);

std::vector<std::string> default_values(const Knob& knob, const Scene& scene);

// A value of a knob on top of these options, as the sweep and --budget do it. The value is one of parse_knob().
OptionTexts with_value(const Knob& knob, std::string_view value, OptionTexts options);

// "SCENE -o FILE" and the options, quoted for a shell: what follows `lightbench render`.
std::string command_of(const OptionTexts& options, std::string_view output);

} // namespace lightbench
