// Loops without a way out, which drivers turn into a lost device, or end by themselves and go on with what came of it. In: SPIR-V. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace lightbench {

struct EndlessLoop {
    std::string file; // as the compiler knew it; empty, and line 0, where it was not asked to keep that (-g)
    unsigned line = 0;
};

// The first loop of what the entry point calls that can be entered, and then neither left nor ended by a return: with constant conditions
// taken as they are; a discard in a called function does not count as an end. Loops whose end depends on values may be endless all the same.
std::optional<EndlessLoop> endless_loop(std::span<const std::uint32_t> words);

} // namespace lightbench
