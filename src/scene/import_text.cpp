// Lines, words and numbers of text files.
#include "scene/import_text.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace lightbench::importer {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

// Length of the valid UTF-8 sequence at the front (Unicode 15, table 3-7, without the finer limits on the second byte), 0 if there is none.
std::size_t utf8_length(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 0;
    return length;
}

} // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::optional<double> parse_number(std::string_view word) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) return {};
    }
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size() || error == std::errc::invalid_argument) return {};
    if (error != std::errc::result_out_of_range) return value;
    if (word.find("e-") != word.npos || word.find("E-") != word.npos) return 0.0; // from_chars does not tell too small from too big
    return word.starts_with('-') ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

std::optional<long long> parse_integer(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    long long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size() || error != std::errc()) return {};
    return value;
}

std::string_view next_word(std::string_view& rest) {
    while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
    std::size_t length = 0;
    while (length < rest.size() && !is_blank(rest[length])) ++length;
    const std::string_view word = rest.substr(0, length);
    rest.remove_prefix(length);
    return word;
}

std::string clean_name(std::string_view name) {
    std::string clean;
    while (!name.empty()) {
        const std::size_t length = utf8_length(name);
        const auto lead = static_cast<unsigned char>(name[0]);
        if (length == 0 || lead < 0x20 || lead == 0x7F)
            clean += '?';
        else
            clean += name.substr(0, length);
        name.remove_prefix(length == 0 ? 1 : length);
    }
    return clean;
}

std::string_view LineReader::take() {
    std::size_t end = 0;
    while (end < rest.size() && rest[end] != '\n' && rest[end] != '\r') ++end;
    const std::string_view text = rest.substr(0, end);
    const std::size_t taken = std::min(rest.size(), rest.substr(end).starts_with("\r\n") ? end + 2 : end + 1);
    rest.remove_prefix(taken);
    bytes_taken += taken;
    ++lines_taken;
    return text;
}

std::optional<std::string_view> LineReader::next() {
    if (rest.empty()) return {};
    line = lines_taken + 1, start = bytes_taken;
    std::string_view text = take();
    if (!joins || !text.ends_with('\\') || trimmed(text).starts_with('#')) return text; // comments end in paths of other systems
    joined.clear();
    while (text.ends_with('\\')) {
        joined.append(text.substr(0, text.size() - 1)).push_back(' ');
        text = take();
    }
    joined.append(text);
    return joined;
}

} // namespace lightbench::importer
