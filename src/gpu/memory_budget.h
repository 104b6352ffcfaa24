// The device memory that we allow ourselves, and what is taken of it: drivers that keep everything in the host's memory
// (lavapipe) do not enforce their heap, and the kernel would end the process instead.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lightbench::gpu {

struct MemoryLedger {
    std::uint64_t budget = 0, used = 0, peak = 0;          // bytes
    void take(std::uint64_t bytes, std::string_view what); // EnvironmentError beyond the budget, naming what asked
    void give(std::uint64_t bytes);
};

// "512M", "2G", "65536"; nothing if it is not of that form or does not fit.
std::optional<std::uint64_t> parse_bytes(std::string_view text);

// 1536 -> "1.5 KiB".
std::string show_bytes(std::uint64_t bytes);

// CPU devices: the smaller of the heap and 60 % of the memory that the system has available now; others: the heap.
// LIGHTBENCH_MEMORY_BUDGET lowers it; EnvironmentError if that is not a size.
std::uint64_t memory_budget(std::uint64_t heap_bytes, bool is_cpu);

} // namespace lightbench::gpu
