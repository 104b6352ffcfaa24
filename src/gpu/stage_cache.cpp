// A file a module, named after a hash of everything that it comes from.
#include "gpu/stage_cache.h"

#include "gpu/pipeline_cache.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <spirv-tools/libspirv.h>

namespace lightbench::gpu {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1024; // about 16 MB

// Two streams of 64 bits, each word multiplied in as FNV-1a does with bytes; the second turns between, so that they do not fall together.
struct Hash {
    std::uint64_t a = 0xcbf29ce484222325u, b = 0x9e3779b97f4a7c15u;
    void add(std::uint32_t word) {
        a = (a ^ word) * 0x100000001b3u;
        b = (b ^ word) * 0xff51afd7ed558ccdu;
        b ^= b >> 29;
    }
    void add(std::span<const std::uint32_t> words) {
        add(static_cast<std::uint32_t>(words.size()));
        for (const std::uint32_t word : words) add(word);
    }
    void add(std::string_view text) {
        for (const char c : text) add(static_cast<std::uint32_t>(c));
        add(0xffffffffu);
    }
};

CacheFile file_of(const fs::path& folder, const Hash& hash) {
    CacheFile file{.path = folder / fmt::format("stage-{:016x}{:016x}.bin", hash.a, hash.b), .owner = {}, .quiet = true};
    std::memcpy(file.owner.cache_uuid.data(), &hash, sizeof hash);
    return file;
}

// The oldest quarter goes once there are too many: variants of shaders that somebody edits come without end.
void keep_few(const fs::path& folder) {
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->path().filename().string().starts_with("stage-")) files.emplace_back(at->last_write_time(error), at->path());
    if (files.size() <= kMostFiles) return;
    std::ranges::sort(files);
    for (std::size_t i = 0; i < kMostFiles / 4; ++i) fs::remove(files[i].second, error);
}

} // namespace

Words StageCache::kept(std::string_view step, std::span<const std::span<const std::uint32_t>> from, const std::function<Words()>& make) {
    if (!folder_) return make();
    Hash hash;
    hash.add(step);
    hash.add(LIGHTBENCH_SPECIALIZER); // another choice of passes gives other modules
    hash.add(spvSoftwareVersionDetailsString());
    for (const auto& words : from) hash.add(words);
    CacheFile file = file_of(*folder_, hash);
    const std::vector<std::byte> bytes = read_cache(file);
    Words words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), words.size() * 4);
    if (!words.empty()) return words;
    words = make();
    write_cache(file, std::as_bytes(std::span(words)));
    keep_few(*folder_);
    return words;
}

Words StageCache::specialized(const ShaderCode& code, const Constants& constants) {
    Words values;
    for (const auto& [id, value] : constants) values.insert(values.end(), {id, value});
    const std::array<std::span<const std::uint32_t>, 2> from = {code.words, values};
    return kept("specialized", from, [&] { return specialize(code, constants); });
}

Words StageCache::without_unread_outputs(std::span<const std::uint32_t> vertex, std::span<const std::uint32_t> fragment) {
    const std::array<std::span<const std::uint32_t>, 2> from = {vertex, fragment};
    return kept("without unread outputs", from, [&] { return drop_unread_outputs(vertex, fragment); });
}

} // namespace lightbench::gpu
