#include "gpu/spec_defaults.h"

#include "gpu/check.h"

#include <spirv-tools/optimizer.hpp>
#include <unordered_map>

namespace lightbench::gpu {

std::vector<std::uint32_t> with_defaults(const ShaderCode& code, const Constants& constants) {
    if (constants.empty()) return {code.words.begin(), code.words.end()};
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
    for (const auto& [id, value] : constants) values[id] = {value};
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values));
    spvtools::OptimizerOptions options;
    options.set_run_validator(false); // it was valid before
    std::vector<std::uint32_t> out;
    const bool done = optimizer.Run(code.words.data(), code.words.size(), &out, options);
    CHECK(done, "{}", code.name);
    return out;
}

} // namespace lightbench::gpu
