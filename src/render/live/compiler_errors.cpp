#include "render/live/compiler_errors.h"

#include "render/live/shader_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <regex>
#include <sstream>

namespace lightbench {
namespace {

// What follows from an error before it, or says no more than that there was one.
bool says_nothing(std::string_view message) {
    return message.find("compilation terminated") != message.npos || message.find("cannot be preceded by another token") != message.npos ||
           message.find("No code generated") != message.npos || message.find("compilation errors") != message.npos;
}

// "power(f1;f1;" as people wrote it.
std::string plain_name(std::string name) {
    name = name.substr(0, name.find('('));
    const std::size_t begin = name.find_first_not_of(" \t");
    name = begin == name.npos ? "" : name.substr(begin);
    return name.starts_with("original_") ? name.substr(9) : name;
}

// Where a function of this name is defined, by the user before the library.
ShaderError at_function(const std::string& name, const Origins& origins, std::string message) {
    ShaderError found;
    for (const auto& [file, text] : origins.texts) {
        if (!found.message.empty() && !file.starts_with("user/")) continue;
        const auto functions = functions_of(text);
        const auto f = std::ranges::find(functions, name, &FunctionText::name);
        if (f != functions.end()) found = origins.error_at(file, line_number(text, f->name_at), message);
    }
    return found;
}

// "Recursion detected:" and, in the next line, "a(f1; calling b(f1;".
ShaderError recursion(const std::string& next, const Origins& origins) {
    constexpr std::string_view between = " calling ";
    const std::size_t at = next.find(between);
    if (at == next.npos) return {};
    const std::string caller = plain_name(next.substr(0, at)), callee = plain_name(next.substr(at + between.size()));
    const std::string message = caller == callee
                                    ? fmt::format("{} calls itself: GLSL has no recursion", caller)
                                    : fmt::format("{} calls {}, which calls it in turn: GLSL has no recursion", caller, callee);
    return at_function(caller, origins, message);
}

// Of the linker: without a place, but for what the next line may tell.
ShaderError linked(const std::string& message, const std::string& next, const std::string& entry_point, const Origins& origins) {
    if (message.find("Recursion detected") != message.npos)
        if (ShaderError error = recursion(next, origins); !error.message.empty()) return error;
    const bool more = next.starts_with("    ") && next.size() < 500;
    return origins.error_at(entry_point, 0, more ? fmt::format("{} {}", message, plain_name(next)) : message);
}

// The first of a line: what is said of it later follows from that.
void add_first(ShaderErrors& errors, const ShaderError& error) {
    const auto same_line = [&](const ShaderError& e) { return e.file == error.file && e.line == error.line && e.line > 0; };
    if (std::ranges::none_of(errors, same_line)) add_error(errors, error);
}

bool knows(const ShaderErrors& errors, const std::string& message) {
    return std::ranges::find(errors, message, &ShaderError::message) != errors.end();
}

} // namespace

ShaderError Origins::error_at(std::string file, unsigned line, std::string message) const {
    if (!stage.empty() && file.starts_with(stage)) file = file.substr(stage.size() + 1);
    ShaderError error{file, line, std::move(message), ""};
    if (const auto text = texts.find(file); text != texts.end() && line > 0) error.text = line_of(text->second, line);
    if (const auto user = user_files.find(file); user != user_files.end())
        error.file = user->second.string();
    else if (texts.contains(file) || !file.starts_with('/'))
        error.file = (root / file).string();
    return error;
}

void add_error(ShaderErrors& errors, const ShaderError& error) {
    const auto same = [&](const ShaderError& e) { return e.file == error.file && e.line == error.line && e.message == error.message; };
    if (std::ranges::none_of(errors, same)) errors.push_back(error);
}

// "ERROR: lib/phong.glsl:62: 'x' : undeclared identifier".
bool read_errors(const std::string& said, const std::string& entry_point, const Origins& origins, ShaderErrors& errors) {
    static const std::regex located(R"(^ERROR: ([^:\n]{1,500}):(\d{1,9}): ([^\n]{0,1000}))");
    std::vector<std::string> lines;
    std::istringstream in(said);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    lines.emplace_back();
    ShaderErrors of_linker;
    bool placed = false;
    std::smatch match;
    bool included = true; // else what is missing is missed all over
    for (std::size_t i = 0; i + 1 < lines.size() && included; ++i) {
        std::string& line = lines[i];
        included = line.find("Could not process include directive") == line.npos;
        if (!line.starts_with("ERROR: ") || says_nothing(line)) continue;
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (line.size() < 2000 && std::regex_match(line, match, located))
            placed = true, add_first(errors, origins.error_at(match[1], static_cast<unsigned>(std::stoul(match[2])), match[3]));
        else if (of_linker.empty())
            of_linker.push_back(linked(line.substr(7), lines[i + 1], entry_point, origins));
    }
    if (!placed)
        for (const ShaderError& error : of_linker)
            if (!knows(errors, error.message)) errors.push_back(error); // each entry point has it
    return placed || !of_linker.empty();
}

} // namespace lightbench
