// Other defaults for the specialisation constants of a module, which stay open. Pure: no Vulkan.
#pragma once

#include "gpu/specialize.h"

namespace lightbench::gpu {

std::vector<std::uint32_t> with_defaults(const ShaderCode& code, const Constants& constants);

} // namespace lightbench::gpu
