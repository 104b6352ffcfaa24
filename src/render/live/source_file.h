// One file of somebody who is writing a shader: its text, or why it has none.
#pragma once

#include <filesystem>
#include <string>

namespace lightbench {

struct SourceFile {
    std::string text;
    std::string fault; // "is gone", "is a folder"; empty: none
};
SourceFile read_source(const std::filesystem::path& file);

} // namespace lightbench
