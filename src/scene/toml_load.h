// The native format. In: the text of a TOML file and its path. Out: the Scene, or every problem with line and column.
#pragma once

#include "scene/load.h"

#include <string_view>

namespace lightbench {

Loaded load_toml(std::string_view text, const std::filesystem::path& file, const LoadOptions& options);

} // namespace lightbench
