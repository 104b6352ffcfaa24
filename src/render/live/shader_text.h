// GLSL as text: where functions begin and end, one put in another's place, constants made into sliders. Pure.
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
    std::size_t begin = 0, name_at = 0, end = 0; // of the return type, of the name, behind the closing brace
};

// Definitions outside of any other, in order; comments and preprocessor lines are skipped.
std::vector<FunctionText> functions_of(std::string_view glsl);

// `library` with its definition of a function renamed to original_NAME and `include` ("user/mine.glsl") included right behind, so that those
// above still call the original and those below the user's, which may call the original too. None: the library has no such function.
std::optional<std::string> replace_function(const std::string& library, std::string_view name, std::string_view include);

// A constant that a person turns: `const float gain = 0.5; // @slider(0, 1, 0.5)`.
struct Slider {
    std::string file, name;
    float least = 0, most = 1, value = 0;
    std::uint32_t constant = 0; // constant_id
};

// Marked constants, which must be floats outside of functions, become specialisation constants numbered from kFirstSlider + sliders.size();
// they are added to `sliders`. The lines stay where they are. What is marked and cannot be one is an error.
constexpr std::uint32_t kFirstSlider = 1000;
std::string with_sliders(const std::string& glsl, const std::string& file, std::vector<Slider>& sliders, ShaderErrors& errors);

// The line with this number, from 1, without spaces around it.
std::string line_of(std::string_view text, unsigned line);

} // namespace lightbench
