#include "render/live/sliders.h"

#include "render/live/shader_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <regex>

namespace lightbench {
namespace {

constexpr std::size_t kMostLine = 2000; // std::regex goes one frame deeper with each character

bool inside_a_function(const std::vector<FunctionText>& functions, std::size_t at) {
    return std::ranges::any_of(functions, [&](const FunctionText& f) { return at > f.begin && at < f.end; });
}

// "0.5", "+1e3", ".5f": as GLSL has it.
std::optional<float> number_of(std::string text) {
    if (text.starts_with('+')) text.erase(0, 1);
    if (text.ends_with('f') || text.ends_with('F')) text.pop_back();
    float value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

struct Marked {
    Slider slider;
    std::string fault; // empty: it is one
};

Marked slider_of(const std::string& line) {
    static const std::regex form(
        R"(^\s*const\s+float\s+(\w+)\s*=\s*([^;\s]*)\s*;\s*//\s*@slider\(\s*([^,()\s]+)\s*,\s*([^,()\s]+)\s*(?:,\s*([^,()\s]+)\s*)?\).*$)");
    Marked out{{}, "a slider is a line such as \"const float gain = 0.5; // @slider(0, 1)\", least and most, outside of functions"};
    std::smatch match;
    if (line.size() > kMostLine || !std::regex_match(line, match, form)) return out;
    const auto value = number_of(match[2]), least = number_of(match[3]), most = number_of(match[4]);
    const auto again = match[5].matched ? number_of(match[5]) : value;
    if (!value || !least || !most || !again) return out;
    Slider& s = out.slider;
    s.name = match[1], s.least = *least, s.most = *most, s.value = *value;
    if (!(s.least < s.most))
        out.fault = fmt::format("the slider's least value, {:g}, must be below its most, {:g}", s.least, s.most);
    else if (!(s.least <= s.value && s.value <= s.most))
        out.fault = fmt::format("{} is {:g}; its slider goes from {:g} to {:g}", s.name, s.value, s.least, s.most);
    else if (*again != s.value)
        out.fault = fmt::format("{} is {:g}, but its slider begins with {:g}; @slider({:g}, {:g}) begins with the constant's own value",
                                s.name, s.value, *again, s.least, s.most);
    else
        out.fault.clear();
    return out;
}

} // namespace

std::string with_sliders(const std::string& glsl, const std::string& file, std::vector<Slider>& sliders, ShaderErrors& errors) {
    if (glsl.find("@slider") == std::string::npos) return glsl;
    const auto functions = functions_of(glsl);
    std::string out;
    unsigned number = 0;
    for (std::size_t at = 0; at < glsl.size();) {
        const std::size_t end = std::min(glsl.find('\n', at), glsl.size());
        std::string line = glsl.substr(at, end - at);
        ++number;
        if (line.find("@slider") != std::string::npos) {
            if (line.ends_with('\r')) line.pop_back();
            Marked marked = slider_of(line);
            if (marked.fault.empty() && inside_a_function(functions, at)) marked.fault = "a slider is a constant outside of functions";
            if (marked.fault.empty()) {
                Slider& slider = marked.slider;
                slider.file = file, slider.constant = kFirstSlider + static_cast<std::uint32_t>(sliders.size());
                line = fmt::format("layout(constant_id = {}) const float {} = {:#};", slider.constant, slider.name, slider.value);
                sliders.push_back(slider);
            } else
                errors.push_back({file, number, marked.fault, line_of(line, 1)});
        }
        out += line;
        if (end < glsl.size()) out += '\n';
        at = end + 1;
    }
    return out;
}

} // namespace lightbench
