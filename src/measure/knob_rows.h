// The rows of the table of knobs, by topic, and what they are written with. Inside this room only.
#pragma once

#include "measure/knobs.h"

#include <utility>

namespace lightbench {

std::vector<Knob> surface_knobs();
std::vector<Knob> sampling_knobs();
std::vector<Knob> ray_knobs();
std::vector<Knob> radiosity_knobs();

// "gouraud/2" -> "gouraud", "2"; without a slash the second is empty.
std::pair<std::string_view, std::string_view> split_value(std::string_view value);
std::optional<double> number_of(std::string_view text); // above 0, finite, all of the text
void set_if_absent(OptionTexts& options, std::string_view flag, std::string_view text);
void set(OptionTexts& options, std::string_view flag, std::string_view text);
bool apply_number(std::string_view value, OptionTexts& options, std::string_view flag); // false: not a number above 0
// False: none of the names.
bool apply_name(std::string_view value, OptionTexts& options, std::string_view flag, std::initializer_list<std::string_view> names);
std::optional<Scale> scale_of_number(std::string_view value, const OptionTexts&);  // x: the value, which is a number
std::optional<Scale> scale_of_inverse(std::string_view value, const OptionTexts&); // x: 1 / the value
void unset(OptionTexts& options, std::initializer_list<std::string_view> flags);

} // namespace lightbench
