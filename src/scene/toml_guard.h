// Refuses TOML that would exhaust the parser, before the parser sees it: nesting (recursive destructors), value counts, endless strings.
// In: the bytes of a file. Out: the first such problem. Everything else is left for the parser to judge.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lightbench {

struct GuardFault {
    unsigned line = 1, column = 1;
    std::string text;
};

std::optional<GuardFault> toml_fault(std::string_view text);

} // namespace lightbench
