// A folder for files that nobody needs later.
#pragma once

#include <filesystem>
#include <string_view>

namespace lightbench {

// Made where the system keeps such things, named lightbench-PURPOSE-..., gone with this. Throws FileError if it cannot be made.
struct TemporaryFolder {
    std::filesystem::path path;
    explicit TemporaryFolder(std::string_view purpose);
    TemporaryFolder(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
};

} // namespace lightbench
