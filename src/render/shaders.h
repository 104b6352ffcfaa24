// The embedded entry points by name, and the texts that they were compiled from.
#pragma once

#include "gpu/shader_code.h"

namespace lightbench {

// CHECKs that there is one of this name ("raster/surface.frag").
gpu::ShaderCode find_shader(std::string_view name);

struct ShaderSource {
    std::string_view name, text; // path below shaders/
};
std::span<const ShaderSource> built_in_sources(); // generated at build time

} // namespace lightbench
