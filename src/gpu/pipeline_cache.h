// The pipeline cache on disk: one file a device and driver, in $LIGHTBENCH_CACHE_DIR, $XDG_CACHE_HOME/lightbench or ~/.cache/lightbench.
// A file that is corrupt, foreign or cut short is ignored with a warning; drivers are not trusted to check it themselves.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace lightbench::gpu {

// Whose cache it is: a file of another driver or another version of it must not be handed to this one.
struct CacheOwner {
    std::uint32_t vendor = 0, device = 0, driver_version = 0;
    std::array<std::uint8_t, 16> cache_uuid{}, driver_uuid{};
};

struct CacheFile {
    std::filesystem::path path;
    CacheOwner owner;
    std::uint64_t stored = 0; // checksum of what the file holds; 0: nothing
    bool quiet = false;       // no line on standard error
};

// The folder that the environment names; nothing with LIGHTBENCH_NO_CACHE=1 or without a home.
std::optional<std::filesystem::path> cache_folder();

CacheFile cache_file(const std::filesystem::path& folder, const CacheOwner& owner);

// The driver's bytes; empty if there is no file or it is no good (then one line on standard error).
std::vector<std::byte> read_cache(CacheFile& file);

// Writes beside, then renames. What is there already is not written again. One line on standard error if it cannot be written.
void write_cache(CacheFile& file, std::span<const std::byte> bytes);

} // namespace lightbench::gpu
