// GLSL as text: where functions begin and end, one put in another's place. Pure.
#pragma once

#include "render/live/shader_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

struct FunctionText {
    std::string name;
    std::string head;                            // "float a(vec3 n, float s[2])", on one line
    std::string signature;                       // types alone: "float(vec3,float[2])"
    std::size_t begin = 0, name_at = 0, end = 0; // of the return type, of the name, behind the closing brace
};

// Definitions outside of any other, in order; comments and preprocessor lines are skipped.
std::vector<FunctionText> functions_of(std::string_view glsl);

// `library` with its definition of a function renamed to original_NAME and `include` ("user/mine.glsl") included right behind, so that those
// above still call the original and those below the user's, which may call the original too. None: the library has no such function.
std::optional<std::string> replace_function(const std::string& library, std::string_view name, std::string_view include);

// The line with this number, from 1, without spaces around it.
std::string line_of(std::string_view text, unsigned line);
// The number of the line that holds this character.
unsigned line_number(std::string_view text, std::size_t at);

} // namespace lightbench
