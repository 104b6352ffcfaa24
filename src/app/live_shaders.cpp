#include "app/live_shaders.h"

#include "app/errors.h"
#include "app/options.h"
#include "gpu/errors.h"
#include "image/file_bytes.h"
#include "render/live/fits.h"
#include "render/live/source_file.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>

namespace lightbench {

gpu::Constants slider_constants(const std::vector<Slider>& sliders, const std::map<std::string, float>& values) {
    std::vector<std::string> names;
    for (const Slider& slider : sliders) names.push_back(slider.name);
    gpu::Constants constants;
    for (const auto& [name, value] : values) {
        const auto slider = std::ranges::find(sliders, name, &Slider::name);
        if (slider == sliders.end())
            throw UserError("--slider", fmt::format("no constant named \"{}\" is marked as a slider; {}", name,
                                                    names.empty() ? "none is" : fmt::format("it must be {}", alternatives(names))));
        if (!(slider->least <= value && value <= slider->most))
            throw UserError("--slider",
                            fmt::format("{} is {:g}; it must lie between {:g} and {:g}", name, value, slider->least, slider->most));
    }
    for (const Slider& slider : sliders) {
        const auto value = values.find(slider.name);
        constants[slider.constant] = std::bit_cast<std::uint32_t>(value == values.end() ? slider.value : value->second);
    }
    return constants;
}

bool names_shader_sources() {
    const char* named = std::getenv("LIGHTBENCH_SHADERS");
    return named != nullptr && *named != '\0';
}

std::filesystem::path shader_sources(bool required) {
    std::filesystem::path sources = find_shader_sources();
    if (names_shader_sources() && !std::filesystem::is_directory(sources))
        throw UserError("LIGHTBENCH_SHADERS", fmt::format("there is no folder {}; it must be a copy of shaders/", sources.string()));
    if (names_shader_sources() && !std::filesystem::is_regular_file(sources / "shade.glsl"))
        throw UserError("LIGHTBENCH_SHADERS", fmt::format("{} holds no shade.glsl; it must be a copy of shaders/", sources.string()));
    if (sources.empty() && required)
        throw gpu::EnvironmentError(
            "the program's shader sources, into which --shader is put, are missing (LIGHTBENCH_SHADERS names their folder)");
    return sources;
}

ShaderTree tree_with(const std::filesystem::path& root, const std::vector<std::filesystem::path>& files) {
    Problems problems;
    for (const auto& file : files)
        if (!std::filesystem::exists(file))
            problems.push_back({file.string(), 0, 0, "there is no such file"});
        else if (const std::string fault = read_source(file).fault; !fault.empty())
            problems.push_back({file.string(), 0, 0, fault});
    if (!problems.empty()) throw UserError(problems);
    return ShaderTree(root, files);
}

std::set<std::string> edited_entry_points(const ShaderTree& tree, const std::filesystem::path& root, const std::vector<Slider>& sliders) {
    std::vector<std::string> files = tree.edited();
    for (const Slider& slider : sliders) files.push_back(std::filesystem::path(slider.file).lexically_relative(root).generic_string());
    std::set<std::string> names = tree.dependents(files);
    names.merge(tree.replaced());
    return names;
}

void use_shaders(gpu::Device& device, const std::vector<std::filesystem::path>& files, const std::map<std::string, float>& sliders) {
    if (files.empty() && sliders.empty() && !names_shader_sources()) return;
    const std::filesystem::path root = shader_sources(true);
    const ShaderTree tree = tree_with(root, files);
    CompiledShaders compiled = tree.compile(edited_entry_points(tree, root, tree.compile({}).sliders));
    if (!compiled.errors.empty()) {
        std::vector<std::string> lines;
        for (const ShaderError& error : compiled.errors) lines.push_back(to_string(error));
        throw UserError(lines);
    }
    device.replace_shaders(std::move(compiled.modules), slider_constants(compiled.sliders, sliders));
}

void write_modules(const ShaderModules& modules, const std::filesystem::path& folder) {
    for (const auto& [name, words] : modules) {
        const std::filesystem::path file = folder / (name + ".spv");
        std::filesystem::create_directories(file.parent_path());
        write_file(file.string(), std::string_view(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(std::uint32_t)));
    }
}

void use_modules(gpu::Device& device, const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) throw UserError("--spirv", fmt::format("there is no folder {}", folder.string()));
    ShaderModules modules;
    Problems problems;
    for (const gpu::ShaderCode& own : lightbench_shaders_table()) {
        const std::filesystem::path file = folder / fmt::format("{}.spv", own.name);
        if (!std::filesystem::exists(file)) continue;
        const auto bytes = read_file(file.string());
        std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
        if (!words.empty()) std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
        for (const std::string& sentence : misfits(own, words)) problems.push_back({file.string(), 0, 0, sentence});
        modules[std::string(own.name)] = std::move(words);
    }
    if (modules.empty())
        problems.push_back({"--spirv", 0, 0, fmt::format("{} holds no entry point, such as raster/surface.frag.spv", folder.string())});
    if (!problems.empty()) throw UserError(problems);
    device.replace_shaders(std::move(modules));
}

} // namespace lightbench
