#include "app/live_shaders.h"

#include "app/errors.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

namespace lightbench {

gpu::Constants slider_constants(const std::vector<Slider>& sliders, const std::map<std::string, float>& values) {
    gpu::Constants constants;
    for (const auto& [name, value] : values) {
        const auto slider = std::ranges::find(sliders, name, &Slider::name);
        if (slider == sliders.end()) throw UserError("--slider", fmt::format("no constant named \"{}\" is marked as a slider", name));
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

void use_shaders(gpu::Device& device, const std::vector<std::filesystem::path>& files, const std::map<std::string, float>& sliders) {
    if (files.empty() && sliders.empty()) return;
    const std::filesystem::path sources = find_shader_sources();
    if (sources.empty())
        throw gpu::EnvironmentError(
            "the program's shader sources, into which --shader is put, are missing (LIGHTBENCH_SHADERS names their folder)");
    for (const auto& file : files)
        if (!std::filesystem::is_regular_file(file)) throw UserError(file.string(), "is not a file that can be read");
    const ShaderTree tree(sources, files);
    CompiledShaders compiled = tree.compile(tree.replaced());
    if (!compiled.errors.empty()) {
        std::vector<std::string> lines;
        for (const ShaderError& error : compiled.errors) lines.push_back(to_string(error));
        throw UserError(lines);
    }
    device.replace_shaders(std::move(compiled.modules), slider_constants(compiled.sliders, sliders));
}

} // namespace lightbench
