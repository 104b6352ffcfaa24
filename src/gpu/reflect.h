// What a SPIR-V module binds and expects. In: words (specialised first: reflection lists dead bindings too). Out: a Reflection.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>
#include <vulkan/vulkan.hpp>

namespace lightbench::gpu {

enum class BindingKind {
    uniform_texel,
    storage_texel,
    storage_buffer,
    uniform_buffer,
    combined_image_sampler,
    sampled_image,
    storage_image,
    sampler
};

const char* to_string(BindingKind kind);

struct ReflectedBinding {
    std::string name{}; // of the variable; of its block if the variable has none
    std::uint32_t set = 0, binding = 0;
    BindingKind kind{};
    bool read = true, written = false; // by its decorations: `readonly`, `writeonly`
    std::uint32_t block_size = 0;      // bytes of a block without its run-time array; 0 if not a block
    std::uint32_t array_stride = 0;    // bytes between elements of the block's run-time array; 0 if none
    std::uint32_t count = 1;           // descriptors
};

struct ReflectedVariable {
    std::uint32_t location = 0;
    vk::Format format{}; // R32G32B32_SFLOAT for a vec3, and so on
    std::string name{};
};

struct Reflection {
    vk::ShaderStageFlagBits stage{};
    std::vector<ReflectedBinding> bindings{};  // ordered by set, then binding
    std::uint32_t push_size = 0;               // bytes of the push constant block; 0: none
    std::array<std::uint32_t, 3> local_size{}; // compute only
    std::vector<ReflectedVariable> inputs{};   // ordered by location
    std::vector<ReflectedVariable> outputs{};
    const ReflectedBinding* find(std::string_view name) const; // null: none
};

Reflection reflect(std::span<const std::uint32_t> words);

} // namespace lightbench::gpu
