#include "measure/knobs.h"

#include "measure/knob_rows.h"
#include "scene/nearest.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace lightbench {
namespace {

std::vector<Knob> all_rows() {
    std::vector<Knob> all;
    for (auto rows : {surface_knobs, sampling_knobs, ray_knobs, radiosity_knobs})
        for (Knob& knob : rows()) all.push_back(std::move(knob));
    return all;
}

std::vector<std::string> split_list(std::string_view text) {
    std::vector<std::string> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        parts.emplace_back(text.substr(start, comma - start));
        start = comma + 1;
    }
    return parts;
}

std::string unknown_name(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Knob& knob : knobs()) names.push_back(knob.name);
    names.push_back(kFunctionsKnob);
    if (const auto near = nearest_name(name, names)) return fmt::format("there is no knob \"{}\"; did you mean \"{}\"?", name, *near);
    return fmt::format("there is no knob \"{}\"; it must be one of {}", name, fmt::join(names, ", "));
}

// "2e+2" as "200": what is the same number has the same text.
OptionTexts with_plain_numbers(OptionTexts options) {
    for (auto& [flag, text] : options) {
        const std::size_t after = text.rfind('=') + 1; // of "density=8"; 0 without one
        if (const auto number = number_of(std::string_view(text).substr(after))) text = text.substr(0, after) + fmt::format("{}", *number);
    }
    return options;
}

std::string problem_of(const Knob& knob, const std::vector<std::string>& values) {
    std::map<OptionTexts, std::string_view> seen;
    for (const std::string& value : values) {
        OptionTexts applied;
        if (value.empty()) return fmt::format("a value of {} is empty; it must be {}", knob.name, knob.values);
        if (value.ends_with('/') || !knob.apply(value, applied))
            return fmt::format("\"{}\" is no value of {}; it must be {}", value, knob.name, knob.values);
        const auto [first, fresh] = seen.emplace(with_plain_numbers(applied), value);
        if (!fresh && first->second == value) return fmt::format("{}: \"{}\" is there twice; once is enough", knob.name, value);
        if (!fresh) return fmt::format("{}: \"{}\" and \"{}\" are the same; once is enough", knob.name, first->second, value);
    }
    return "";
}

bool is_plain(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) || std::string_view("-_./,:=+%").find(static_cast<char>(c)) != std::string_view::npos;
    });
}

std::string in_shell(std::string_view text) {
    if (is_plain(text)) return std::string(text);
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

} // namespace

std::span<const Knob> knobs() {
    static const std::vector<Knob> all = all_rows();
    return all;
}

const Knob* find_knob(std::string_view name) {
    const auto it = std::ranges::find(knobs(), name, &Knob::name);
    return it == knobs().end() ? nullptr : &*it;
}

std::optional<KnobUse> parse_knob(std::string_view text, std::string& problem) {
    const std::size_t equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    const Knob* knob = find_knob(name);
    if (name == kFunctionsKnob) return problem = fmt::format("{} has no values; the name alone is right", name), std::nullopt;
    if (!knob) return problem = unknown_name(name), std::nullopt;
    KnobUse use{knob, {}};
    if (equals != std::string_view::npos) use.values = split_list(text.substr(equals + 1));
    problem = problem_of(*knob, use.values);
    return problem.empty() ? std::optional(use) : std::nullopt;
}

std::vector<std::string> default_values(const Knob& knob, const Scene& scene) {
    if (knob.defaults_of) return knob.defaults_of(scene);
    return {knob.defaults.begin(), knob.defaults.end()};
}

OptionTexts with_value(const Knob& knob, std::string_view value, OptionTexts options) {
    if (!knob.method.empty()) set_if_absent(options, "--method", knob.method);
    knob.apply(value, options);
    return options;
}

std::string command_of(const OptionTexts& options, std::string_view output) {
    const auto scene = options.find("SCENE");
    std::string command = scene == options.end() ? "" : fmt::format("{} ", in_shell(scene->second));
    command += fmt::format("-o {}", in_shell(output));
    for (const auto& [flag, text] : options)
        if (flag.starts_with("--")) command += text.empty() ? fmt::format(" {}", flag) : fmt::format(" {} {}", flag, in_shell(text));
    return command;
}

// --- for the rows -----------------------------------------------------------------------------------------------------------------

std::pair<std::string_view, std::string_view> split_value(std::string_view value) {
    const std::size_t slash = value.find('/');
    if (slash == std::string_view::npos) return {value, {}};
    return {value.substr(0, slash), value.substr(slash + 1)};
}

std::optional<double> number_of(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || value <= 0) return std::nullopt;
    return value;
}

bool apply_number(std::string_view value, OptionTexts& options, std::string_view flag) {
    set(options, flag, value);
    return number_of(value).has_value();
}

bool apply_name(std::string_view value, OptionTexts& options, std::string_view flag, std::initializer_list<std::string_view> names) {
    set(options, flag, value);
    return std::ranges::find(names, value) != names.end();
}

std::optional<Scale> scale_of_number(std::string_view value, const OptionTexts&) {
    return Scale{"", number_of(value).value_or(1)};
}

std::optional<Scale> scale_of_inverse(std::string_view value, const OptionTexts&) {
    return Scale{"", 1 / number_of(value).value_or(1)};
}

void set_if_absent(OptionTexts& options, std::string_view flag, std::string_view text) {
    options.try_emplace(std::string(flag), text);
}

void set(OptionTexts& options, std::string_view flag, std::string_view text) {
    options.insert_or_assign(std::string(flag), std::string(text));
}

void unset(OptionTexts& options, std::initializer_list<std::string_view> flags) {
    for (const std::string_view flag : flags)
        if (const auto it = options.find(flag); it != options.end()) options.erase(it);
}

} // namespace lightbench
