// What glslang says, brought home to the files that people wrote.
#pragma once

#include "render/live/shader_error.h"

#include <filesystem>
#include <map>

namespace lightbench {

// Where names of the copy that was compiled came from.
struct Origins {
    const std::filesystem::path& root;
    const std::map<std::string, std::filesystem::path>& user_files; // by their names in the copy
    const std::map<std::string, std::string>& texts;                // likewise, of all files
    std::string stage;                                              // folder of the copy

    ShaderError error_at(std::string file, unsigned line, std::string message) const;
};

// Unless the same is among them.
void add_error(ShaderErrors& errors, const ShaderError& error);

// Adds the errors in what was said about an entry point; what follows from an error with a place is left out. False: there is none.
bool read_errors(const std::string& said, const std::string& entry_point, const Origins& origins, ShaderErrors& errors);

} // namespace lightbench
