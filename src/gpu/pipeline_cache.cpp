// Reads and writes the cache file: a header of our own, then the driver's bytes.
#include "gpu/pipeline_cache.h"

#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace lightbench::gpu {
namespace {

constexpr std::uint32_t kMagic = 0x4350424C; // "LBPC"
constexpr std::uint32_t kVersion = 1;
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 30; // a header that promises more is not believed

struct Header {
    std::uint32_t magic = kMagic, version = kVersion;
    CacheOwner owner;
    std::uint32_t reserved = 0;
    std::uint64_t bytes = 0, checksum = 0;
};
static_assert(sizeof(Header) == 72 && sizeof(CacheOwner) == 44); // no padding: headers are compared and stored as bytes

// FNV-1a, 64 bits (Fowler, Noll, Vo 1991).
std::uint64_t checksum(std::span<const std::byte> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (std::byte b : bytes) hash = (hash ^ static_cast<std::uint64_t>(b)) * 0x100000001b3u;
    return hash;
}

const char* environment(const char* name) {
    const char* text = std::getenv(name);
    return text && *text ? text : nullptr;
}

void warn(const CacheFile& file, std::string_view what) {
    if (file.quiet) return;
    fmt::print(stderr, "pipeline cache {}: {}\n", file.path.string(), what);
}

// What is wrong with the file's beginning; empty if nothing is.
std::string_view find_fault(const Header& header, const CacheOwner& owner, std::uint64_t bytes_that_follow) {
    if (header.magic != kMagic) return "not a cache of lightbench, ignored";
    if (header.version != kVersion) return "of another version of lightbench, ignored";
    if (std::memcmp(&header.owner, &owner, sizeof owner) != 0) return "of another device or driver, ignored";
    if (header.bytes != bytes_that_follow || header.bytes > kMaxBytes) return "cut short or grown, ignored";
    return {};
}

} // namespace

std::optional<std::filesystem::path> cache_folder() {
    if (const char* text = environment("LIGHTBENCH_NO_CACHE"); text && std::string_view(text) == "1") return {};
    if (const char* folder = environment("LIGHTBENCH_CACHE_DIR")) return folder;
    if (const char* folder = environment("XDG_CACHE_HOME")) return std::filesystem::path(folder) / "lightbench";
    if (const char* home = environment("HOME")) return std::filesystem::path(home) / ".cache" / "lightbench";
    return {};
}

CacheFile cache_file(const std::filesystem::path& folder, const CacheOwner& owner) {
    const std::uint64_t key = checksum(std::as_bytes(std::span(&owner, 1)));
    return {folder / fmt::format("pipelines-{:016x}.bin", key), owner};
}

std::vector<std::byte> read_cache(CacheFile& file) {
    std::ifstream in(file.path, std::ios::binary | std::ios::ate);
    if (!in) return {};
    const auto size = static_cast<std::uint64_t>(std::max<std::streamoff>(in.tellg(), 0));
    Header header;
    in.seekg(0);
    if (size < sizeof header || !in.read(reinterpret_cast<char*>(&header), sizeof header))
        return warn(file, "cut short, ignored"), std::vector<std::byte>();
    if (const auto fault = find_fault(header, file.owner, size - sizeof header); !fault.empty())
        return warn(file, fault), std::vector<std::byte>();
    std::vector<std::byte> bytes(header.bytes);
    if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())) || checksum(bytes) != header.checksum)
        return warn(file, "damaged, ignored"), std::vector<std::byte>();
    file.stored = header.checksum;
    return bytes;
}

void write_cache(CacheFile& file, std::span<const std::byte> bytes) {
    Header header;
    header.owner = file.owner;
    header.bytes = bytes.size();
    header.checksum = checksum(bytes);
    if (bytes.empty() || header.checksum == file.stored) return;
    std::error_code error;
    std::filesystem::create_directories(file.path.parent_path(), error);
    const std::filesystem::path beside = fmt::format("{}.{}", file.path.string(), ::getpid());
    std::ofstream out(beside, std::ios::binary);
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (out) std::filesystem::rename(beside, file.path, error);
    if (!out || error) {
        warn(file, "cannot be written; pipelines are built anew each time");
        std::filesystem::remove(beside, error);
        return;
    }
    file.stored = header.checksum;
}

} // namespace lightbench::gpu
