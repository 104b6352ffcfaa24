#include "render/live/shader_includes.h"

#include <algorithm>
#include <filesystem>
#include <fmt/ranges.h>
#include <set>
#include <string_view>

namespace lightbench {
namespace {

std::string_view without_spaces(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    return begin == text.npos ? std::string_view() : text.substr(begin);
}

// What follows the directive: `"a.glsl"` of `# include "a.glsl"`; empty for other lines.
std::string_view argument_of(std::string_view line, std::string_view directive) {
    line = without_spaces(line);
    if (!line.starts_with('#')) return {};
    line = without_spaces(line.substr(1));
    return line.starts_with(directive) ? without_spaces(line.substr(directive.size())) : std::string_view();
}

template <class F> void for_each_line(std::string_view text, F&& f) {
    for (unsigned number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        f(text.substr(0, end), number);
        text = end == text.npos ? std::string_view() : text.substr(end + 1);
    }
}

// Its first directive is an #ifndef: included again, it is empty.
bool is_guarded(std::string_view text) {
    bool decided = false, guarded = false;
    for_each_line(text, [&](std::string_view line, unsigned) {
        if (decided || !without_spaces(line).starts_with('#')) return;
        decided = true, guarded = !argument_of(line, "ifndef").empty();
    });
    return guarded;
}

struct Walk {
    const SourceTexts& texts;
    std::vector<std::string> path; // files that are open
    std::set<std::string> done;
    std::vector<Circle> found;

    void visit(const std::string& name) {
        if (is_guarded(texts.at(name)) || !done.insert(name).second) return;
        path.push_back(name);
        for (const Include& include : includes_of(texts.at(name))) {
            const auto next = resolve(texts, name, include.name);
            if (!next) continue;
            const auto open = std::ranges::find(path, *next);
            if (open == path.end())
                visit(*next);
            else
                close(name, include.line, {open + 1, path.end()});
        }
        path.pop_back();
    }
    void close(const std::string& name, unsigned line, const std::vector<std::string>& between) {
        found.push_back({name, line,
                         between.empty() ? "includes itself"
                                         : fmt::format("closes a circle of files that include each other: {}", fmt::join(between, ", "))});
    }
};

} // namespace

std::vector<Include> includes_of(const std::string& text) {
    std::vector<Include> includes;
    for_each_line(text, [&](std::string_view line, unsigned number) {
        const std::string_view argument = argument_of(line, "include");
        const std::size_t end = argument.size() > 1 && argument[0] == '"' ? argument.find('"', 1) : argument.npos;
        if (end != argument.npos) includes.push_back({std::string(argument.substr(1, end - 1)), number});
    });
    return includes;
}

std::optional<std::string> resolve(const SourceTexts& texts, const std::string& from, const std::string& name) {
    const auto beside = (std::filesystem::path(from).parent_path() / name).lexically_normal().generic_string();
    if (texts.contains(beside)) return beside;
    if (texts.contains(name)) return name;
    return std::nullopt;
}

std::vector<Circle> circles(const SourceTexts& texts) {
    Walk walk{texts, {}, {}, {}};
    for (const auto& [name, text] : texts) walk.visit(name);
    return walk.found;
}

} // namespace lightbench
