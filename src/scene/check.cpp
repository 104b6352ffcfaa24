// Problems as lines of text, with their sum.
#include "scene/check.h"

#include <fmt/format.h>

namespace lightbench {

std::vector<std::string> problem_lines(const Loaded& loaded, const std::filesystem::path& file) {
    std::vector<std::string> lines;
    for (const Problem& problem : loaded.problems) lines.push_back(to_string(problem));
    if (lines.empty()) return lines;
    const std::size_t count = lines.size() + loaded.unlisted - (loaded.unlisted > 0 ? 1 : 0); // the line that tells of the unlisted is none
    lines.push_back(fmt::format("{} problem{} in {}", count, count == 1 ? "" : "s", file.string()));
    return lines;
}

std::vector<std::string> check_file(const std::filesystem::path& file, const LoadOptions& options) {
    return problem_lines(load_scene(file, options), file);
}

} // namespace lightbench
