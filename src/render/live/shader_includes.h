// Which shader source includes which. In: texts. Out: names, lines, circles that would never end. Pure.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lightbench {

struct Include {
    std::string name; // as written
    unsigned line = 0;
};

// Lines `#include "name"`.
std::vector<Include> includes_of(const std::string& text);

using SourceTexts = std::map<std::string, std::string>; // by path below the root of the shaders

// What the compiler takes for it: beside the including file, else from the root. None: there is no such file.
std::optional<std::string> resolve(const SourceTexts& texts, const std::string& from, const std::string& name);

struct Circle {
    std::string file; // the include in this line of it closes the circle
    unsigned line = 0;
    std::string message; // "includes itself, by way of lib/a.glsl"
};

// Files that include themselves, though by way of others, where no #ifndef around the text of any of them ends it.
std::vector<Circle> circles(const SourceTexts& texts);

} // namespace lightbench
