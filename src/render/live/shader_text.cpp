#include "render/live/shader_text.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <regex>
#include <set>

namespace lightbench {

std::string to_string(const ShaderError& error) {
    const std::string place = error.line > 0 ? fmt::format("{}:{}", error.file, error.line) : error.file;
    return error.text.empty() ? fmt::format("{}: {}", place, error.message)
                              : fmt::format("{}: {}\n    {}", place, error.message, error.text);
}

namespace {

// The text with comments and preprocessor lines blanked, as long as before.
std::string code_of(std::string_view glsl) {
    std::string code(glsl);
    const auto blank = [&](std::size_t from, std::size_t to) {
        for (; from < std::min(to, code.size()); ++from)
            if (code[from] != '\n') code[from] = ' ';
        return from;
    };
    bool line_start = true;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code.compare(i, 2, "//") == 0 || (line_start && code[i] == '#')) {
            std::size_t end = code.find('\n', i);
            while (end != std::string::npos && end > 0 && code[end - 1] == '\\') end = code.find('\n', end + 1);
            i = blank(i, end) - 1;
        } else if (code.compare(i, 2, "/*") == 0) {
            const std::size_t end = code.find("*/", i + 2);
            i = blank(i, end == std::string::npos ? end : end + 2) - 1;
        } else if (code[i] == '\n')
            line_start = true;
        else if (!std::isspace(static_cast<unsigned char>(code[i])))
            line_start = false;
    }
    return code;
}

std::size_t matching(const std::string& code, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < code.size(); ++i) {
        if (code[i] == '{') ++depth;
        if (code[i] == '}' && --depth == 0) return i;
    }
    return std::string::npos;
}

// Words, and brackets with what is between them: "vec3", "p", "[4]".
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    bool in_word = false, in_brackets = false;
    for (const char c : text) {
        const bool space = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!space && (c == '[' || !(in_word || in_brackets))) words.emplace_back();
        if (!space) words.back() += c;
        if (c == '[') in_brackets = true;
        in_word = !space && !in_brackets;
        if (c == ']') in_brackets = false;
    }
    return words;
}

// The type alone: without a name, and without qualifiers that change nothing for a caller.
std::string type_of(std::string_view text, bool named) {
    static const std::set<std::string> idle = {"in", "const", "precise", "highp", "mediump", "lowp"};
    std::string type, brackets;
    std::vector<std::string> plain;
    for (std::string& word : words_of(text))
        if (word[0] == '[')
            brackets += word;
        else if (!idle.contains(word))
            plain.push_back(std::move(word));
    if (named && plain.size() > (plain.size() > 0 && (plain[0] == "out" || plain[0] == "inout") ? 2u : 1u)) plain.pop_back();
    for (const std::string& word : plain) type += (type.empty() ? "" : " ") + word;
    return type + brackets;
}

std::string signature_of(std::string_view returned, std::string_view parameters) {
    std::string signature = type_of(returned, false) + "(";
    for (bool first = true; !parameters.empty(); first = false) {
        const std::size_t end = std::min(parameters.find(','), parameters.size());
        const std::string type = type_of(parameters.substr(0, end), true);
        if (type != "void") signature += (first ? "" : ",") + type;
        parameters.remove_prefix(std::min(end + 1, parameters.size()));
    }
    return signature + ")";
}

std::string on_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const bool space = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!space)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

// std::regex goes one frame deeper with each character: texts that are no heads must not end the stack.
constexpr std::size_t kMostHead = 2000;

// What stands before a brace, from the last end of something: a function's head if it ends with parentheses after a name.
std::optional<FunctionText> head_of(const std::string& code, std::size_t from, std::size_t brace) {
    static const std::regex head(R"(^\s*((?:\w+\s+)*\w+(?:\s*\[\s*\w*\s*\])?)\s+(\w+)\s*\(([^;{}]*)\)\s*$)");
    from = std::max(from, brace - std::min(brace, kMostHead));
    const std::string text = code.substr(from, brace - from);
    std::smatch match;
    if (!std::regex_match(text, match, head)) return std::nullopt;
    FunctionText f;
    f.name = match[2];
    f.head = on_one_line(text.substr(static_cast<std::size_t>(match.position(1))));
    f.signature = signature_of(match.str(1), match.str(3));
    f.begin = from + static_cast<std::size_t>(match.position(1)), f.name_at = from + static_cast<std::size_t>(match.position(2));
    return f;
}

} // namespace

std::vector<FunctionText> functions_of(std::string_view glsl) {
    const std::string code = code_of(glsl);
    std::vector<FunctionText> functions;
    std::size_t from = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code[i] == ';') from = i + 1;
        if (code[i] != '{') continue;
        const std::size_t end = matching(code, i);
        if (end == std::string::npos) break;
        if (auto f = head_of(code, from, i)) f->end = end + 1, functions.push_back(*f);
        i = end, from = end + 1;
    }
    return functions;
}

std::optional<std::string> replace_function(const std::string& library, std::string_view name, std::string_view include) {
    const auto functions = functions_of(library);
    const auto f = std::ranges::find(functions, name, &FunctionText::name);
    if (f == functions.end()) return std::nullopt;
    // #line keeps the numbers of what follows; that directive names the line that comes next.
    return fmt::format("{}original_{}\n#include \"{}\"\n#line {}\n{}", library.substr(0, f->name_at),
                       library.substr(f->name_at, f->end - f->name_at), include, line_number(library, f->end), library.substr(f->end));
}

unsigned line_number(std::string_view text, std::size_t at) {
    return static_cast<unsigned>(1 + std::ranges::count(text.substr(0, at), '\n'));
}

std::string line_of(std::string_view text, unsigned line) {
    for (; line > 1 && !text.empty(); --line) {
        const std::size_t end = text.find('\n');
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    text = text.substr(0, text.find('\n'));
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return std::string(text);
}

} // namespace lightbench
