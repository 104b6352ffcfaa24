// Whether an edited shader can stand where the program's own stood: what does not fit would end the program when a pipeline is made.
#pragma once

#include "gpu/shader_code.h"

#include <string>
#include <vector>

namespace lightbench {

// Why `edited`, words of any origin, cannot take the place of `own`: not valid SPIR-V, another stage or work group, push constants, bindings or
// variables that the program does not provide or expects. Empty: it can.
std::vector<std::string> misfits(const gpu::ShaderCode& own, std::span<const std::uint32_t> edited);

} // namespace lightbench
