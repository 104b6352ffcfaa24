#include "app/numbers.h"

#include <cstdint>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace lightbench {
namespace {

constexpr std::int64_t kMaxFrames = 100000;

std::optional<glm::dvec3> parse_point(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 3) return std::nullopt;
    const auto x = parse_whole<double>(parts[0]), y = parse_whole<double>(parts[1]), z = parse_whole<double>(parts[2]);
    return x && y && z ? std::optional(glm::dvec3(*x, *y, *z)) : std::nullopt;
}

} // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t at; (at = text.find(separator)) != std::string_view::npos; text.remove_prefix(at + 1))
        parts.push_back(text.substr(0, at));
    parts.push_back(text);
    return parts;
}

std::optional<glm::uvec2> parse_size(std::string_view text) {
    const auto parts = split(text, 'x');
    if (parts.size() != 2) return std::nullopt;
    const auto width = parse_whole<std::uint32_t>(parts[0]), height = parse_whole<std::uint32_t>(parts[1]);
    if (!width || !height) return std::nullopt;
    return glm::uvec2(*width, *height);
}

std::optional<Rect> parse_rect(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 4) return std::nullopt;
    std::uint32_t values[4];
    for (std::size_t i = 0; i < 4; ++i) {
        const auto value = parse_whole<std::uint32_t>(parts[i]);
        if (!value) return std::nullopt;
        values[i] = *value;
    }
    return Rect{{values[0], values[1]}, {values[2], values[3]}};
}

std::optional<FrameRange> parse_range(std::string_view text) {
    const auto parts = split(text, ':');
    if (parts.size() != 2) return std::nullopt;
    const auto first = parse_integer(parts[0]), last = parse_integer(parts[1]);
    if (!first || !last || *first > *last || std::int64_t{*last} - *first >= kMaxFrames) return std::nullopt;
    return FrameRange{*first, *last};
}

std::optional<glm::uvec2> parse_pixel(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 2) return std::nullopt;
    const auto x = parse_unsigned<65535>(parts[0]), y = parse_unsigned<65535>(parts[1]);
    return x && y ? std::optional(glm::uvec2(*x, *y)) : std::nullopt;
}

std::optional<glm::vec3> parse_contrast(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 3) return std::nullopt;
    glm::vec3 contrast;
    for (int i = 0; i < 3; ++i) {
        const auto value = parse_number<0, 1>(parts[static_cast<std::size_t>(i)]);
        if (!value) return std::nullopt;
        contrast[i] = static_cast<float>(*value);
    }
    return contrast;
}

std::optional<Camera> parse_camera(std::string_view text) {
    const auto parts = split(text, ':');
    if (parts.size() != 4 && parts.size() != 5) return std::nullopt;
    const auto position = parse_point(parts[0]), target = parse_point(parts[1]), up = parse_point(parts[2]);
    const auto fov = parse_whole<double>(parts[3]), hither = parts.size() == 5 ? parse_whole<double>(parts[4]) : std::optional(0.0);
    if (!position || !target || !up || !fov || !hither) return std::nullopt;
    return Camera{"own", *position, *target, *up, *fov * (glm::pi<double>() / 180), *hither};
}

// A pixel's own sample lies at most 0.71 pixels from its middle: a radius of 1 always has one. Sigma is a third of the radius unless it is
// given, as in the default of 1.5 and 0.5: the bell is cut where it is down to 1/90.
std::optional<glm::vec2> parse_filter(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() > 2) return std::nullopt;
    const auto radius = parse_number<1, 16>(parts[0]);
    const auto sigma = parts.size() == 2 ? parse_number<0, 16>(parts[1]) : radius ? std::optional(*radius / 3) : std::nullopt;
    if (!radius || !sigma || *sigma < 0.1) return std::nullopt;
    return glm::vec2(*radius, *sigma);
}

NamedTexts split_parameters(const std::vector<std::string>& texts, Problems& problems) {
    NamedTexts arguments;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            problems.push_back({"--param", 0, 0, fmt::format("\"{}\" must be NAME=VALUE", text)});
        else
            arguments.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    return arguments;
}

} // namespace lightbench
