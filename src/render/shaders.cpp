#include "render/shaders.h"

#include "gpu/check.h"

namespace lightbench {

gpu::ShaderCode find_shader(std::string_view name) {
    for (const auto& code : lightbench_shaders_table())
        if (code.name == name) return code;
    CHECK(false, "no shader is named {}", name);
    return {};
}

} // namespace lightbench
