// Readers of numbers, colors, vectors, words; one message for each way in which a value can be wrong.
#include "scene/toml_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lightbench {
namespace {

constexpr std::array<std::string_view, 3> kChannels{"red", "green", "blue"};
constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::string_view, 2> kParts{"first", "second"};

bool obeys(double value, const Rule& rule) {
    const bool low = rule.low_excluded ? value > rule.low : value >= rule.low;
    const bool high = rule.high_excluded ? value < rule.high : value <= rule.high;
    return low && high;
}

// `stored` is what remains of `value` in the type that keeps it: a float may round onto a bound that is excluded.
bool check(const Section& section, const toml::node& node, std::string_view name, double value, double stored, const Rule& rule) {
    if (!std::isfinite(value))
        fault(section, node, fmt::format("{} is {}; it must be a finite number", name, value));
    else if (!obeys(value, rule) || !obeys(stored, rule))
        fault(section, node, fmt::format("{} is {}; {}", name, value, rule.text));
    else
        return true;
    return false;
}

bool wrong_type(const Section& section, const toml::node& node, std::string_view name, std::string_view wanted) {
    fault(section, node, fmt::format("{} is {}; it must be {}", name, kind_name(node), wanted));
    return false;
}

template <class Number> double kept_as(double value) {
    if constexpr (std::is_same_v<Number, float>)
        return std::abs(value) <= kLargestFloat ? static_cast<double>(static_cast<float>(value)) : value;
    else
        return value;
}

template <class Number>
bool number_of(const Section& section, const toml::node& node, std::string_view name, Number& out, const Rule& rule,
               std::string_view wanted) {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) return wrong_type(section, node, name, wanted);
    if (!check(section, node, name, *value, kept_as<Number>(*value), rule)) return false;
    out = static_cast<Number>(*value);
    return true;
}

// Every element is checked, so that all that is wrong is told at once.
template <class Vector, std::size_t N>
bool elements_of(const Section& section, const toml::node& node, std::string_view name, Vector& out, const Rule& rule,
                 const std::array<std::string_view, N>& parts, std::string_view wanted) {
    const toml::array* array = node.as_array();
    if (!array) return wrong_type(section, node, name, wanted);
    if (array->size() != N) {
        fault(section, node, fmt::format("{} has {} element{}; it must be {}", name, array->size(), array->size() == 1 ? "" : "s", wanted));
        return false;
    }
    Vector value{};
    bool fine = true;
    for (std::size_t i = 0; i < N; ++i)
        fine &= number_of(section, (*array)[i], fmt::format("{}'s {}", name, parts[i]), value[static_cast<int>(i)], rule, "a number");
    if (fine) out = value;
    return fine;
}

} // namespace

void fault(const Section& section, const toml::source_region& where, std::string_view text) {
    report(*section.log, section.file, where.begin.line, where.begin.column, fmt::format("{}: {}", section.who, text));
}

void fault(const Section& section, const toml::node& where, std::string_view text) {
    fault(section, where.source(), text);
}

const toml::source_region& place_of(const Section& section, std::string_view key) {
    const toml::node* node = section.table->get(key);
    return node ? node->source() : section.table->source();
}

const toml::node* find(Section& section, std::string_view key) {
    section.known.push_back(key);
    return section.table->get(key);
}

std::string_view kind_name(const toml::node& node) {
    switch (node.type()) {
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "a whole number";
    case toml::node_type::floating_point: return "a number with a fraction";
    case toml::node_type::boolean: return "true or false";
    case toml::node_type::array: return "an array";
    case toml::node_type::table: return "a table";
    default: return "a date or time";
    }
}

bool read(Section& section, std::string_view key, double& out, const Rule& rule) {
    const toml::node* node = find(section, key);
    return node && number_of(section, *node, key, out, rule, "a number");
}

bool read(Section& section, std::string_view key, float& out, const Rule& rule) {
    const toml::node* node = find(section, key);
    return node && number_of(section, *node, key, out, rule, "a number");
}

bool read(Section& section, std::string_view key, bool& out) {
    const toml::node* node = find(section, key);
    if (!node) return false;
    const auto value = node->value_exact<bool>();
    if (!value) return wrong_type(section, *node, key, "true or false");
    out = *value;
    return true;
}

bool read(Section& section, std::string_view key, std::string& out) {
    const toml::node* node = find(section, key);
    if (!node) return false;
    const auto value = node->value_exact<std::string>();
    if (!value) return wrong_type(section, *node, key, "a string");
    out = *value;
    return true;
}

// Names are printed by the plan and by probes: one that could steer the terminal is refused.
bool read_name(Section& section, std::string_view key, std::string& out) {
    std::string name;
    if (!read(section, key, name)) return false;
    const auto steers = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    if (std::any_of(name.begin(), name.end(), steers)) {
        fault(section, *section.table->get(key),
              fmt::format("the {} {} holds a control character; it must be printable", key, in_quotes(name)));
        return false;
    }
    out = std::move(name);
    return true;
}

bool read_whole(Section& section, std::string_view key, unsigned& out, unsigned low, unsigned high) {
    const toml::node* node = find(section, key);
    if (!node) return false;
    const auto value = node->value_exact<std::int64_t>();
    if (!value) return wrong_type(section, *node, key, "a whole number");
    if (*value < low || *value > high) {
        fault(section, *node, fmt::format("{} is {}; it must lie between {} and {}", key, *value, low, high));
        return false;
    }
    out = static_cast<unsigned>(*value);
    return true;
}

bool read_color(Section& section, std::string_view key, glm::vec3& out, const Rule& rule) {
    constexpr std::string_view kWanted = "a number or [r, g, b]";
    const toml::node* node = find(section, key);
    if (!node) return false;
    if (node->is_array()) return elements_of(section, *node, key, out, rule, kChannels, kWanted);
    float grey = 0;
    if (!number_of(section, *node, key, grey, rule, kWanted)) return false;
    out = glm::vec3(grey);
    return true;
}

bool read_vector(Section& section, std::string_view key, glm::dvec3& out, const Rule& rule) {
    const toml::node* node = find(section, key);
    return node && vector_of(section, *node, key, out, rule);
}

bool read_pair(Section& section, std::string_view key, glm::dvec2& out, const Rule& rule) {
    constexpr std::string_view kWanted = "a number or two numbers in an array";
    const toml::node* node = find(section, key);
    if (!node) return false;
    if (node->is_array()) return elements_of(section, *node, key, out, rule, kParts, kWanted);
    double both = 0;
    if (!number_of(section, *node, key, both, rule, kWanted)) return false;
    out = glm::dvec2(both);
    return true;
}

std::size_t read_choice(Section& section, std::string_view key, std::span<const std::string_view> words) {
    std::string word;
    if (!read(section, key, word)) return std::string_view::npos;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == word) return i;
    const std::string meant = did_you_mean(word, words);
    const std::string rest = meant.empty() ? fmt::format("; it must be one of \"{}\"", fmt::join(words, "\", \"")) : meant;
    fault(section, *section.table->get(key), fmt::format("unknown {} {}{}", key, in_quotes(word), rest));
    return std::string_view::npos;
}

bool vector_of(const Section& section, const toml::node& node, std::string_view name, glm::dvec3& out, const Rule& rule) {
    return elements_of(section, node, name, out, rule, kAxes, "three numbers [x, y, z]");
}

void report_unknown_keys(const Section& section) {
    for (const auto& [key, node] : *section.table) {
        if (std::find(section.known.begin(), section.known.end(), key.str()) != section.known.end()) continue;
        if (full(*section.log)) {
            ++section.log->unlisted;
            continue;
        }
        std::string rest = did_you_mean(key.str(), section.known);
        if (rest.empty()) rest = fmt::format("; the keys are {}", fmt::join(section.known, ", "));
        fault(section, key.source(), fmt::format("unknown key {}{}", in_quotes(key.str()), rest));
    }
}

} // namespace lightbench
