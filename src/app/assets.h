// Where the scenes that come with the program lie.
#pragma once

#include <filesystem>

namespace lightbench {

// The first of these that is a folder: LIGHTBENCH_ASSETS, share/lightbench/assets beside the folder of the program (installed), assets/ of the
// source tree that it was built from. Throws gpu::EnvironmentError that names where it looked.
std::filesystem::path find_assets();

} // namespace lightbench
