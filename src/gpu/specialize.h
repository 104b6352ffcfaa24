// Specialisation before the driver sees a module: constants set and frozen, what they make dead removed, bindings included.
// In: SPIR-V with open constants, their values. Out: SPIR-V without specialisation constants. Pure: no Vulkan.
#pragma once

#include "gpu/shader_code.h"

#include <map>
#include <vector>

namespace lightbench::gpu {

using Constants = std::map<std::uint32_t, std::uint32_t>; // constant_id -> the value's 32 bits; ids that the module lacks are ignored

// Constants that are not given keep their defaults. Floating-point arithmetic is left as it was written: only code that cannot run goes.
// Live variables keep their names. Inputs that nothing reads go; outputs stay, so a vertex stage never falls short of its fragment stage.
std::vector<std::uint32_t> specialize(const ShaderCode& code, const Constants& constants);

// The vertex stage without the outputs that the fragment stage does not read, and without what was computed for them alone.
// No fragment words: depth only, nothing but the position stays. Both stages are specialised first.
std::vector<std::uint32_t> drop_unread_outputs(std::span<const std::uint32_t> vertex, std::span<const std::uint32_t> fragment);

} // namespace lightbench::gpu
