// Functions of the user's files in the place of the library's. In: sources. Out: the same, put together; what is wrong with them. Pure.
#pragma once

#include "render/live/shader_tree.h"

namespace lightbench {

// The library file that defines one of the functions of a user's file, and which.
struct Place {
    std::string library, function;
};
std::vector<Place> places_of(const std::map<std::string, std::string>& texts, const std::string& user_text);

struct Replaced {
    std::map<std::string, std::string> texts;
    ShaderErrors errors;
    std::vector<std::string> faulty; // names of files with errors
};

// A file that replaces nothing is a mistake: its functions would never be called. So are two that replace the same, and one that is called
// with other types. `root` is for messages.
Replaced replace_functions(const Sources& sources, const std::map<std::string, std::filesystem::path>& replacements,
                           const std::filesystem::path& root);

} // namespace lightbench
