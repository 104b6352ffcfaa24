// Shaders of the user's own in place of the program's. In: files with functions, values of their sliders. Out: a device that uses them.
#pragma once

#include "gpu/device.h"
#include "render/live/shader_tree.h"

#include <filesystem>
#include <map>

namespace lightbench {

// Constants for these sliders: the named values, else their first ones. Throws UserError for names that no slider has and values out of range.
gpu::Constants slider_constants(const std::vector<Slider>& sliders, const std::map<std::string, float>& values);

// Compiles what the files reach. Throws UserError with every error of every file.
void use_shaders(gpu::Device& device, const std::vector<std::filesystem::path>& files, const std::map<std::string, float>& sliders);

} // namespace lightbench
