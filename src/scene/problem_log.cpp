// Keeping, counting and quoting of problems.
#include "scene/problem_log.h"

#include "scene/nearest.h"

#include <fmt/format.h>
#include <utility>

namespace lightbench {

bool full(const ProblemLog& log) {
    return log.kept.size() >= log.max;
}

void report(ProblemLog& log, std::string_view file, unsigned line, unsigned column, std::string text) {
    if (full(log)) {
        ++log.unlisted;
        return;
    }
    log.kept.push_back({std::string(file), line, column, std::move(text)});
}

void report_all(ProblemLog& log, const Problems& problems) {
    for (const Problem& problem : problems) report(log, problem.file, problem.line, problem.column, problem.text);
}

Problems listed(const ProblemLog& log, std::string_view file) {
    Problems problems = log.kept;
    if (log.unlisted > 0)
        problems.push_back({std::string(file), 0, 0, fmt::format("and {} more problem{}", log.unlisted, log.unlisted == 1 ? "" : "s")});
    return problems;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kShown = 60;
    std::string out = "\"";
    for (std::size_t i = 0; i < text.size() && i < kShown; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < 0x20 || byte == 0x7f)
            out += fmt::format("\\x{:02x}", byte);
        else
            out += text[i];
    }
    return out + (text.size() > kShown ? "...\"" : "\"");
}

std::string did_you_mean(std::string_view typed, std::span<const std::string_view> names) {
    const auto nearest = nearest_name(typed, names);
    return nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : std::string();
}

} // namespace lightbench
