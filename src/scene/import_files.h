// Files that the import reads, and the rule which of them it may read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lightbench {

using Bytes = std::vector<std::uint8_t>;

// The whole of a regular file of at most limits::kMaxFileBytes, or one sentence why not. Never blocks on a pipe or a device.
std::variant<Bytes, std::string> read_whole_file(const std::filesystem::path& file);

// Where an imported file may look for the files that it names.
struct Surroundings {
    std::filesystem::path folder; // names are relative to it
    std::filesystem::path root;   // may not be left, links followed, unless allow_outside
    bool allow_outside = false;
};

enum class Reference { found, missing, outside };

struct Resolved {
    Reference reference = Reference::missing;
    std::filesystem::path file;
};

// A name as files of any system write it: backslashes separate folders too, if nothing has that very name. What does not exist is missing
// wherever it is said to be: a file from elsewhere often holds paths of its author's machine, which endanger nobody.
Resolved resolve(const Surroundings& around, std::string_view name);

} // namespace lightbench
