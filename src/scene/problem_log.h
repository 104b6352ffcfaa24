// Gathers the problems of one load: all are counted, the first `max` are kept. Text that came from a file is quoted harmlessly.
#pragma once

#include "scene/problem.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace lightbench {

struct ProblemLog {
    std::size_t max = 100;
    Problems kept;
    std::size_t unlisted = 0; // found, but beyond `max`
    bool empty() const { return kept.empty() && unlisted == 0; }
};

// Nothing more is kept: the text of a further problem need not be made, which a file with a million of them would notice.
bool full(const ProblemLog& log);

void report(ProblemLog& log, std::string_view file, unsigned line, unsigned column, std::string text);
void report_all(ProblemLog& log, const Problems& problems);

// The kept problems, and as the last one "and N more problems" if some are not listed.
Problems listed(const ProblemLog& log, std::string_view file);

// In double quotes, at most 60 bytes, control characters as \xNN: a file must not steer the terminal that shows its problems.
std::string in_quotes(std::string_view text);

// Empty, or `; did you mean "radius"?`.
std::string did_you_mean(std::string_view typed, std::span<const std::string_view> names);

} // namespace lightbench
