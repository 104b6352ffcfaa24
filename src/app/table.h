// Tables as text. In: rows of cells, the first with the headings. Out: lines whose columns stand below each other.
#pragma once

#include <string>
#include <vector>

namespace lightbench {

std::string aligned(const std::vector<std::vector<std::string>>& rows);

} // namespace lightbench
