// What is wrong with a shader that somebody is writing, at the place where they wrote it.
#pragma once

#include <string>
#include <vector>

namespace lightbench {

struct ShaderError {
    std::string file;    // as the user knows it
    unsigned line = 0;   // from 1; 0: the whole file
    std::string message; // of the compiler, or ours
    std::string text;    // of that line, without spaces around; empty if there is none
};
using ShaderErrors = std::vector<ShaderError>;

// "shaders/lib/phong.glsl:62: 'x' : undeclared identifier\n    float nl = dot(n, l) + x;"
std::string to_string(const ShaderError& error);

} // namespace lightbench
