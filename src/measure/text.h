// Text of data (names of scenes, notes, commands) put where another language would read it. In: any bytes. Out: text that does no harm there.
#pragma once

#include <string>
#include <string_view>

namespace lightbench {

// Valid UTF-8 without control characters: those become spaces, bytes that are no UTF-8 become "?".
std::string printable(std::string_view text);

// For HTML, between tags and inside quoted attributes; UTF-8 as in printable().
std::string html_escaped(std::string_view text);

// A string of gnuplot, quotes included: within single quotes it expands neither commands nor macros nor escapes.
std::string gnuplot_quoted(std::string_view text);

// Letters, digits and "-", at most 80: part of a file name. "cook-torrance/2 x" becomes "cook-torrance-2-x".
std::string file_word(std::string_view text);

} // namespace lightbench
