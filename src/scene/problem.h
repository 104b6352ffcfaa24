// A problem of the user's input, with its place; and the result of everything that reads input.
#pragma once

#include <string>
#include <vector>

namespace lightbench {

// Printed as `file:line:column: text`; parts that are 0 are left out. The text says what is wrong and what would be right.
struct Problem {
    std::string file;
    unsigned line = 0, column = 0;
    std::string text;
};

using Problems = std::vector<Problem>;

std::string to_string(const Problem& problem);

} // namespace lightbench
