// The budget's arithmetic and its sources.
#include "gpu/memory_budget.h"

#include "gpu/check.h"
#include "gpu/errors.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace lightbench::gpu {

void MemoryLedger::take(std::uint64_t bytes, std::string_view what) {
    if (bytes > budget - used)
        throw EnvironmentError(fmt::format("{} needs {} of device memory, but of the budget of {} only {} are left", what,
                                           show_bytes(bytes), show_bytes(budget), show_bytes(budget - used)));
    used += bytes;
    peak = std::max(peak, used);
}

void MemoryLedger::give(std::uint64_t bytes) {
    CHECK(bytes <= used);
    used -= bytes;
}

std::optional<std::uint64_t> parse_bytes(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end == text.data()) return {};
    const std::string_view suffix = text.substr(static_cast<std::size_t>(end - text.data()));
    const int shift = suffix.empty() ? 0 : suffix == "K" ? 10 : suffix == "M" ? 20 : suffix == "G" ? 30 : -1;
    if (shift < 0 || value > std::numeric_limits<std::uint64_t>::max() >> shift) return {};
    return value << shift;
}

std::string show_bytes(std::uint64_t bytes) {
    if (bytes < 1024) return fmt::format("{} bytes", bytes);
    const char* const units[] = {"KiB", "MiB", "GiB", "TiB"};
    double value = static_cast<double>(bytes) / 1024;
    std::size_t unit = 0;
    for (; value >= 1024 && unit < 3; ++unit) value /= 1024;
    return fmt::format("{:.1f} {}", value, units[unit]);
}

namespace {

// /proc/meminfo's MemAvailable; everything, where the system does not say.
std::uint64_t available_host_bytes() {
    std::ifstream file("/proc/meminfo");
    std::string key;
    std::uint64_t kib = 0;
    while (file >> key >> kib) {
        if (key == "MemAvailable:") return kib * 1024;
        file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return std::numeric_limits<std::uint64_t>::max();
}

} // namespace

std::uint64_t memory_budget(std::uint64_t heap_bytes, bool is_cpu) {
    std::uint64_t budget = is_cpu ? std::min(heap_bytes, available_host_bytes() / 10 * 6) : heap_bytes;
    if (const char* text = std::getenv("LIGHTBENCH_MEMORY_BUDGET"); text && *text) {
        const auto asked = parse_bytes(text);
        if (!asked)
            throw EnvironmentError(
                fmt::format("LIGHTBENCH_MEMORY_BUDGET is \"{}\"; it must be a size such as 268435456, 512M or 2G", text));
        budget = std::min(budget, *asked);
    }
    return budget;
}

} // namespace lightbench::gpu
