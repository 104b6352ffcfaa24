// Files that a scene names: where they may lie and what they may be. In: names out of a file that nobody trusts. Out: a path that may be
// opened, or the reason why not; the bytes of a regular file within a limit, or the reason why not.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace lightbench {

struct Resolved {
    std::filesystem::path path; // folder / name, as people would type it
    std::string why;            // empty: fine; else what is wrong, and what would be right
};

// `name` is relative to `folder` and, symbolic links followed, may not leave it unless allow_outside. It must be a regular file that exists.
Resolved resolve_file(const std::filesystem::path& folder, std::string_view name, bool allow_outside);

struct Bytes {
    std::optional<std::string> text; // absent: see why
    std::string why;
};

// Never waits (a pipe without writer) and never reads without end (a device): only regular files of at most `limit` bytes are read.
Bytes read_file(const std::filesystem::path& file, std::size_t limit, std::string_view limit_name);

// The folder that a file lies in; "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& file);

} // namespace lightbench
