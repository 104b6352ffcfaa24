// Numbers of the command line, whole texts only: "12x" is not 12. Nothing: not understood or out of range.
#pragma once

#include "app/options.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace lightbench {

template <class T> std::optional<T> parse_whole(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

inline std::optional<int> parse_integer(std::string_view text) {
    return parse_whole<int>(text);
}

template <std::uint32_t max> std::optional<std::uint32_t> parse_unsigned(std::string_view text) {
    const auto value = parse_whole<std::uint32_t>(text);
    return value && *value <= max ? value : std::nullopt;
}

template <int min, int max> std::optional<double> parse_number(std::string_view text) {
    const auto value = parse_whole<double>(text);
    return value && *value >= min && *value <= max ? value : std::nullopt; // false for NaN
}

template <std::uint32_t max> std::optional<std::uint32_t> parse_square(std::string_view text) {
    const auto value = parse_unsigned<max>(text);
    if (!value || *value == 0) return std::nullopt;
    const auto root = static_cast<std::uint32_t>(std::lround(std::sqrt(double(*value))));
    return root * root == *value ? value : std::nullopt;
}

std::optional<glm::uvec2> parse_size(std::string_view text);    // 1280x720
std::optional<Rect> parse_rect(std::string_view text);          // X,Y,W,H
std::optional<glm::uvec2> parse_pixel(std::string_view text);   // X,Y
std::optional<FrameRange> parse_range(std::string_view text);   // A:B
std::optional<glm::vec3> parse_contrast(std::string_view text); // R,G,B in [0, 1]
std::optional<glm::vec2> parse_filter(std::string_view text);   // R or R,SIGMA: radius and sigma
std::optional<Camera> parse_camera(std::string_view text);      // PX,PY,PZ:TX,TY,TZ:UX,UY,UZ:FOV[:HITHER], degrees

std::vector<std::string_view> split(std::string_view text, char separator);

// What --param takes, NAME=VALUE each; a text without a name or "=" is a problem.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;
NamedTexts split_parameters(const std::vector<std::string>& texts, Problems& problems);

} // namespace lightbench
