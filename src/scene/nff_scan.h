// Scanner of NFF text: words and numbers with their places, comments and line ends skipped; numbers are read without regard to the locale.
#pragma once

#include <optional>
#include <string_view>

namespace lightbench {

struct NffScanner {
    const char* at;
    const char* end;
    const char* line_start;
    unsigned line = 1;
    unsigned column() const { return static_cast<unsigned>(at - line_start) + 1; }
};

NffScanner nff_scanner(std::string_view text);

// To the next character that is neither blank nor comment, over line ends; false at the end of the file.
bool skip_to_word(NffScanner& s);

// The same within the line; false at its end.
bool skip_to_word_in_line(NffScanner& s);

void skip_line(NffScanner& s);

// The word under the scanner, not taken.
std::string_view peek_word(const NffScanner& s);
inline void take(NffScanner& s, std::string_view word) {
    s.at += word.size();
}

// The number under the scanner, taken if the whole word is one; infinite if it does not fit a double.
std::optional<double> take_number(NffScanner& s);

} // namespace lightbench
