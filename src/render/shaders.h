// The embedded entry points by name.
#pragma once

#include "gpu/shader_code.h"

namespace lightbench {

// CHECKs that there is one of this name ("raster/surface.frag").
gpu::ShaderCode find_shader(std::string_view name);

} // namespace lightbench
