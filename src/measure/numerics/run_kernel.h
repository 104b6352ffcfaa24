// Runs shaders/numerics/NAME.comp, or another kernel of the same frame, over inputs on the device. Out: results, and which invocations did not say that they finished.
#pragma once

#include "measure/numerics/inputs.h"

#include "gpu/device.h"
#include "gpu/shader_code.h"

#include <array>
#include <cstdint>
#include <string>

namespace lightbench::kernels {

struct KernelRun {
    std::string kernel;
    Inputs inputs;
    std::size_t arity = 1;      // floats a result
    std::vector<float> results; // result after result
    std::size_t missing = 0;    // invocations without a completion flag
    std::size_t first_missing = 0;
    std::span<const float> result(std::size_t i) const { return {results.data() + i * arity, arity}; }
};

// NAME.comp of shaders/numerics/; CHECKs that there is one.
const gpu::ShaderCode& find_kernel(std::string_view name);

using Words = std::vector<std::array<std::uint32_t, 4>>;

// words: the table `texels` of kernels that read pictures (shaders/numerics/texel_kernel.glsl).
KernelRun run_kernel(gpu::Device& device, const gpu::ShaderCode& code, Inputs inputs, std::size_t result_arity = 1,
                     const Words& words = {});

} // namespace lightbench::kernels
