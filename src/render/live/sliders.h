// Constants of shaders that a person turns. In: GLSL. Out: the same with specialisation constants in their place. Pure.
#pragma once

#include "render/live/shader_error.h"

#include <cstdint>

namespace lightbench {

// `const float gain = 0.5; // @slider(0, 1)`: 0.5 is its first value, [0, 1] what it may be.
struct Slider {
    std::string file, name;
    float least = 0, most = 1, value = 0;
    std::uint32_t constant = 0; // constant_id
};

// Marked constants, which must be floats outside of functions, become specialisation constants numbered from kFirstSlider + sliders.size();
// they are added to `sliders`. The lines stay where they are. What is marked and cannot be one is an error. The mark may repeat the first
// value: `@slider(0, 1, 0.5)`.
constexpr std::uint32_t kFirstSlider = 1000;
std::string with_sliders(const std::string& glsl, const std::string& file, std::vector<Slider>& sliders, ShaderErrors& errors);

} // namespace lightbench
