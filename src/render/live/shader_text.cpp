#include "render/live/shader_text.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <regex>

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

// std::regex goes one frame deeper with each character: texts that are no heads must not end the stack.
constexpr std::size_t kMostHead = 2000;

// What stands before a brace, from the last end of something: a function's head if it ends with parentheses after a name.
std::optional<FunctionText> head_of(const std::string& code, std::size_t from, std::size_t brace) {
    static const std::regex head(R"(^\s*((?:\w+\s+)*\w+(?:\s*\[\s*\w*\s*\])?)\s+(\w+)\s*\([^;{}]*\)\s*$)");
    from = std::max(from, brace - std::min(brace, kMostHead));
    const std::string text = code.substr(from, brace - from);
    std::smatch match;
    if (!std::regex_match(text, match, head)) return std::nullopt;
    FunctionText f;
    f.name = match[2];
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
    const auto line = 1 + std::count(library.begin(), library.begin() + static_cast<std::ptrdiff_t>(f->end), '\n');
    // #line keeps the numbers of what follows; that directive names the line that comes next.
    return fmt::format("{}original_{}\n#include \"{}\"\n#line {}\n{}", library.substr(0, f->name_at),
                       library.substr(f->name_at, f->end - f->name_at), include, line, library.substr(f->end));
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

namespace {

bool inside_a_function(const std::vector<FunctionText>& functions, std::size_t at) {
    return std::ranges::any_of(functions, [&](const FunctionText& f) { return at > f.begin && at < f.end; });
}

// `const float gain = 0.5; // @slider(0, 1, 0.5)`: the constant of which this is a line.
std::optional<Slider> slider_of(const std::string& line) {
    static const std::regex marked(
        R"(^\s*const\s+float\s+(\w+)\s*=[^;]*;\s*//\s*@slider\(\s*([-+.\deE]+)\s*,\s*([-+.\deE]+)\s*,\s*([-+.\deE]+)\s*\).*$)");
    std::smatch match;
    if (line.size() > kMostHead || !std::regex_match(line, match, marked)) return std::nullopt;
    Slider s;
    s.name = match[1];
    try {
        s.least = std::stof(match[2]), s.most = std::stof(match[3]), s.value = std::stof(match[4]);
    } catch (const std::exception&) {
        return std::nullopt;
    }
    if (!(s.least < s.most) || !(s.least <= s.value && s.value <= s.most)) return std::nullopt;
    return s;
}

} // namespace

std::string with_sliders(const std::string& glsl, const std::string& file, std::vector<Slider>& sliders, ShaderErrors& errors) {
    if (glsl.find("@slider") == std::string::npos) return glsl;
    const auto functions = functions_of(glsl);
    std::string out;
    unsigned number = 0;
    for (std::size_t at = 0; at < glsl.size();) {
        const std::size_t end = std::min(glsl.find('\n', at), glsl.size());
        const std::string line = glsl.substr(at, end - at);
        auto slider = ++number > 0 && line.find("@slider") != std::string::npos ? slider_of(line) : std::nullopt;
        if (line.find("@slider") != std::string::npos && (!slider || inside_a_function(functions, at))) {
            errors.push_back({file, number,
                              "a slider is a line such as \"const float gain = 0.5; // @slider(0, 1, 0.5)\", least, most and first value, "
                              "outside of functions",
                              line_of(line, 1)});
            slider.reset();
        }
        if (slider) {
            slider->file = file, slider->constant = kFirstSlider + static_cast<std::uint32_t>(sliders.size());
            out += fmt::format("layout(constant_id = {}) const float {} = {:#};", slider->constant, slider->name, slider->value);
            sliders.push_back(*slider);
        } else
            out += line;
        if (end < glsl.size()) out += '\n';
        at = end + 1;
    }
    return out;
}

} // namespace lightbench
