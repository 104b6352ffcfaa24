// What `check` prints of one file, and every command that refuses one.
#pragma once

#include "scene/load.h"

#include <string>
#include <vector>

namespace lightbench {

// One line a problem, as `room.toml:14:13: ...`, and last "2 problems in room.toml". Empty if there are none.
std::vector<std::string> problem_lines(const Loaded& loaded, const std::filesystem::path& file);

// Loads the file and forgets the scene.
std::vector<std::string> check_file(const std::filesystem::path& file, const LoadOptions& options = {});

} // namespace lightbench
