#include "app/numbers.h"

#include <cstdint>
#include <vector>

namespace lightbench {
namespace {

constexpr std::int64_t kMaxFrames = 100000;

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t at; (at = text.find(separator)) != std::string_view::npos; text.remove_prefix(at + 1))
        parts.push_back(text.substr(0, at));
    parts.push_back(text);
    return parts;
}

} // namespace

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

} // namespace lightbench
