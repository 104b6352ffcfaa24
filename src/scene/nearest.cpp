// Edit distance, row by row.
#include "scene/nearest.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>
#include <vector>

namespace lightbench {
namespace {

// Levenshtein 1965; Wagner and Fischer 1974, "The String-to-String Correction Problem", two rows of their matrix at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

} // namespace

std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> names) {
    constexpr std::size_t kLongestWord = 64; // a longer one is no slip of the pen, and the matrix is quadratic
    if (word.size() > kLongestWord) return std::nullopt;
    std::optional<std::string_view> best;
    std::size_t fewest = 0;
    for (const std::string_view name : names) {
        const std::size_t edits = edit_distance(word, name);
        if (edits * 3 > std::max(word.size(), name.size()) || (best && edits >= fewest)) continue;
        best = name, fewest = edits;
    }
    return best;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> names) {
    if (names.empty()) return "; it takes none";
    if (const auto near = nearest_name(word, names)) return fmt::format("; did you mean \"{}\"?", *near);
    return fmt::format("; there are {}", fmt::join(names, ", "));
}

} // namespace lightbench
