// Reading text by lines, words and numbers, without copying. In: the text of a file. Out: views into it, and line numbers for messages.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lightbench::importer {

// A file's content as bytes, and bytes as text.
inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline std::string_view text_of(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string_view trimmed(std::string_view text);

// A decimal number that fills the whole word; +-infinity where it is too big for a double, "nan" and "inf" as they are; no hex, no comma.
std::optional<double> parse_number(std::string_view word);
std::optional<long long> parse_integer(std::string_view word);

// Takes the next word (blanks around it dropped) off the front of `rest`; empty at the end.
std::string_view next_word(std::string_view& rest);

// A name as Scene keeps it: valid UTF-8 without control characters; anything else becomes '?'.
std::string clean_name(std::string_view name);

// One logical line after the other: the ends LF, CR LF and CR; a backslash before the end joins two lines if `joins`,
// but never to a comment.
struct LineReader {
    std::string_view rest;
    bool joins = false;
    unsigned line = 0;     // of the last line returned, counted from 1
    std::size_t start = 0; // its place in the text
    std::optional<std::string_view> next();

    unsigned lines_taken = 0;
    std::size_t bytes_taken = 0;
    std::string joined;
    std::string_view take();
};

} // namespace lightbench::importer
