// Character by character over text in memory.
#include "scene/nff_scan.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>

namespace lightbench {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
bool ends_word(char c) {
    return is_blank(c) || c == '\n';
}

const char* line_end(const NffScanner& s) {
    const void* found = std::memchr(s.at, '\n', static_cast<std::size_t>(s.end - s.at));
    return found ? static_cast<const char*>(found) : s.end;
}

} // namespace

NffScanner nff_scanner(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.substr(0, 3) == kByteOrderMark) text.remove_prefix(3);
    return {text.data(), text.data() + text.size(), text.data()};
}

bool skip_to_word_in_line(NffScanner& s) {
    while (s.at != s.end && is_blank(*s.at)) ++s.at;
    if (s.at != s.end && *s.at == '#') s.at = line_end(s);
    return s.at != s.end && *s.at != '\n';
}

bool skip_to_word(NffScanner& s) {
    while (!skip_to_word_in_line(s)) {
        if (s.at == s.end) return false;
        skip_line(s);
    }
    return true;
}

void skip_line(NffScanner& s) {
    s.at = line_end(s);
    if (s.at == s.end) return;
    s.line_start = ++s.at;
    ++s.line;
}

std::string_view peek_word(const NffScanner& s) {
    const char* stop = std::find_if(s.at, s.end, ends_word);
    return {s.at, static_cast<std::size_t>(stop - s.at)};
}

std::optional<double> take_number(NffScanner& s) {
    const bool plus = s.end - s.at > 1 && *s.at == '+' && s.at[1] != '-'; // from_chars knows no plus sign
    const char* first = s.at + plus;
    double value = 0;
    const auto [stop, error] = std::from_chars(first, s.end, value);
    if (error == std::errc::invalid_argument || (stop != s.end && !ends_word(*stop))) return std::nullopt;
    if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
    s.at = stop;
    return value;
}

} // namespace lightbench
