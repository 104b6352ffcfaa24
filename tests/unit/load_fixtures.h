// A folder of its own for each test, files written into it, and problems as the lines that people read.
#pragma once

#include "scene/load.h"

#include <atomic>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace lightbench::testing_files {

// Owns a new empty folder; it is removed with everything in it.
class Folder {
  public:
    Folder() : path_(fresh()) { std::filesystem::create_directories(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::filesystem::path& name, std::string_view text) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }

  private:
    static std::filesystem::path fresh() {
        static std::atomic<int> count = 0;
        return std::filesystem::temp_directory_path() / fmt::format("lightbench-load-{}-{}", ::getpid(), count++);
    }
    std::filesystem::path path_;
};

// Without the folder: `room.toml:3:1: ...`.
inline std::vector<std::string> lines_of(const Loaded& loaded, const Folder& folder) {
    std::vector<std::string> lines;
    for (const Problem& problem : loaded.problems) {
        std::string line = to_string(problem);
        const std::string prefix = folder.path().string() + "/";
        if (line.rfind(prefix, 0) == 0) line.erase(0, prefix.size());
        lines.push_back(line);
    }
    return lines;
}

// The scene, or the test fails with what is wrong.
inline Scene scene_of(Loaded loaded) {
    for (const Problem& problem : loaded.problems) ADD_FAILURE() << to_string(problem);
    EXPECT_TRUE(loaded.scene.has_value());
    return loaded.scene ? std::move(*loaded.scene) : Scene{};
}

} // namespace lightbench::testing_files
