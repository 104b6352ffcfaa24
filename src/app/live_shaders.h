// Shaders of the user's own in place of the program's. In: files with functions, values of their sliders. Out: a device that uses them.
#pragma once

#include "gpu/device.h"
#include "render/live/shader_tree.h"

#include <filesystem>
#include <map>

namespace lightbench {

// Constants for these sliders: the named values, else their first ones. Throws UserError for names that no slider has and values out of range.
gpu::Constants slider_constants(const std::vector<Slider>& sliders, const std::map<std::string, float>& values);

// LIGHTBENCH_SHADERS is set: its folder counts in the place of what the program was built from.
bool names_shader_sources();

// find_shader_sources(). Throws UserError if LIGHTBENCH_SHADERS names no such folder, gpu::EnvironmentError if there are none but must be.
std::filesystem::path shader_sources(bool required);

// `root` with the files' functions in it. Throws UserError for files that cannot be read.
ShaderTree tree_with(const std::filesystem::path& root, const std::vector<std::filesystem::path>& files);

// Entry points that the files reach, those that sliders of the folder do, and those whose sources there the program was not built from.
std::set<std::string> edited_entry_points(const ShaderTree& tree, const std::filesystem::path& root, const std::vector<Slider>& sliders);

// Compiles what edited_entry_points() names, if there are files or sliders or LIGHTBENCH_SHADERS is set. Throws UserError with every error of every file.
void use_shaders(gpu::Device& device, const std::vector<std::filesystem::path>& files, const std::map<std::string, float>& sliders);

// Compiled entry points below a folder: "raster/surface.frag.spv". What is read takes its place in the device once it is known to fit there;
// throws UserError with all that does not.
void write_modules(const ShaderModules& modules, const std::filesystem::path& folder);
void use_modules(gpu::Device& device, const std::filesystem::path& folder);

} // namespace lightbench
