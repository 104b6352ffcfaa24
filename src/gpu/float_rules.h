// What compilers of drivers may make of floating-point arithmetic, and how a module forbids it.
// In: SPIR-V after specialisation. Out: the same module with the device's rules written into it. Pure: no Vulkan.
#pragma once

#include <cstdint>
#include <vector>

namespace lightbench::gpu {

// Both are off on CPUs: lavapipe and SwiftShader keep NaN and fuse nothing as it is, and a module that says so is compiled to other code.
struct FloatRules {
    bool keep_nan = false; // else `x < a ? a : x` may become a maximum, which loses a NaN: SignedZeroInfNanPreserve of SPIR-V 1.4
    bool unfused = false;  // else a b + c may be rounded once in one shader and twice in another: NoContraction on all arithmetic
    bool operator==(const FloatRules&) const = default;
};

std::vector<std::uint32_t> apply_float_rules(std::vector<std::uint32_t> words, const FloatRules& rules);

} // namespace lightbench::gpu
