// One embedded SPIR-V module and the name of the GLSL file it was compiled from. No Vulkan here: tests of the plan look into the words.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace lightbench::gpu {

struct ShaderCode {
    std::string_view name;                // path below shaders/, for example "raster/surface.frag"
    std::span<const std::uint32_t> words; // SPIR-V 1.6, validated at build time, specialisation constants still open
};

} // namespace lightbench::gpu

// Every entry point of the program, generated at build time.
std::span<const lightbench::gpu::ShaderCode> lightbench_shaders_table();
