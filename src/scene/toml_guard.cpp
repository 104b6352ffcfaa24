// One pass over the bytes that knows TOML's strings and comments and nothing else of its grammar. Up to the first syntax error it reads
// strings exactly as the parser does, and beyond that the parser does not go, so nothing can be hidden from it in quotes.
#include "scene/toml_guard.h"

#include "scene/limits.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

struct Guard {
    std::string_view text;
    std::size_t at = 0;
    std::size_t depth = 0; // of [ and {
    std::size_t dots = 0;  // of the dotted key that is being read: each is a table in a table
    std::size_t values = 0;
    std::string fault;
};

bool starts(const Guard& g, std::string_view what) {
    return g.text.substr(g.at, what.size()) == what;
}

// `at` is on the first quote; leaves it behind the last one, or at the end of the line of a one-line string without end.
void skip_string(Guard& g) {
    const char quote = g.text[g.at];
    const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
    const bool multi = starts(g, triple);
    const std::size_t begin = g.at;
    g.at += multi ? 3 : 1;
    while (g.at < g.text.size()) {
        const char c = g.text[g.at];
        if (c == '\\' && quote == '"') {
            g.at += 2;
            continue;
        }
        if (!multi && (c == quote || c == '\n')) {
            g.at += c == quote;
            break;
        }
        if (multi && starts(g, triple)) {
            g.at += 3;
            for (int extra = 0; extra < 2 && g.at < g.text.size() && g.text[g.at] == quote; ++extra)
                ++g.at; // """" ends with a quote inside
            break;
        }
        ++g.at;
    }
    g.at = std::min(g.at, g.text.size());
    if (g.at - begin > limits::kMaxStringBytes) {
        g.at = begin;
        g.fault = fmt::format("this text is longer than {} bytes (limit kMaxStringBytes)", limits::kMaxStringBytes);
    }
}

void skip_comment(Guard& g) {
    g.at = std::min(g.text.find('\n', g.at), g.text.size());
}

void open_bracket(Guard& g) {
    if (++g.depth > limits::kMaxNesting)
        g.fault = fmt::format("nested deeper than {} levels (limit kMaxNesting); a scene needs 3", limits::kMaxNesting);
}

void count_dot(Guard& g) {
    if (++g.dots > limits::kMaxNesting)
        g.fault = fmt::format("a dotted key of more than {} parts (limit kMaxNesting); a scene needs 2", limits::kMaxNesting);
}

void count_value(Guard& g) {
    if (++g.values > limits::kMaxTomlValues)
        g.fault = fmt::format("more than {} values (limit kMaxTomlValues); write large scenes as .nff", limits::kMaxTomlValues);
}

void step(Guard& g) {
    const char c = g.text[g.at];
    if (c == '"' || c == '\'') return skip_string(g);
    if (c == '#') return skip_comment(g);
    if (c == '.') count_dot(g);
    if (c == '[' || c == '{') open_bracket(g);
    if ((c == ']' || c == '}') && g.depth > 0) --g.depth;
    if (c == ',' || c == '=' || c == '[') count_value(g);
    if (c == '[' || c == ']' || c == '{' || c == '}' || c == ',' || c == '=' || c == '\n') g.dots = 0;
    if (c == '\0') g.fault = "a NUL byte; a scene file is text";
    if (g.fault.empty()) ++g.at;
}

} // namespace

std::optional<GuardFault> toml_fault(std::string_view text) {
    Guard g{text, 0, 0, 0, 0, {}};
    while (g.at < text.size() && g.fault.empty()) step(g);
    if (g.fault.empty()) return std::nullopt;
    const std::string_view before = text.substr(0, g.at);
    const auto lines = static_cast<unsigned>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t line_start = before.rfind('\n') + 1; // npos + 1 is 0
    return GuardFault{lines + 1, static_cast<unsigned>(g.at - line_start) + 1, g.fault};
}

} // namespace lightbench
