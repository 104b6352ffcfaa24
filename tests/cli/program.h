// Runs the built program as its users do: arguments in, exit code and both streams out. Validation is on; a message of it is exit code 3.
#pragma once

#include "support/files.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace lightbench::cli {

struct Ran {
    int code = -1; // of the program; 128 + signal if one ended it
    std::string out, err;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

// `before`: shell commands that come first (a limit, a trap).
Ran run(const std::vector<std::string>& arguments, const Environment& more = {}, const std::string& before = "");

// A folder of its own for each test, gone afterwards.
class Cli : public ::testing::Test {
  protected:
    Cli();
    ~Cli() override;
    std::string in_folder(const std::string& name) const { return (folder / name).string(); }
    std::string scene(const std::string& text, const std::string& name = "scene.toml") const; // written; its path
    std::vector<std::string> files() const;                                                   // names, sorted
    std::filesystem::path folder;
};

// A red ball in front of a wall, one point light, a camera, 64x48.
extern const char* const kBall;
// One directional light, no highlight anywhere.
extern const char* const kPlain;

} // namespace lightbench::cli
