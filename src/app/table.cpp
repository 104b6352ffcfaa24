// Every column is as wide as its widest cell; the last one ends where its text does.
#include "app/table.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i + 1 < widths.size(); ++i) text += fmt::format("{:{}}  ", row[i], widths[i]);
        text += row.back() + "\n";
    }
    return text;
}

} // namespace lightbench
