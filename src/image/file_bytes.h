// Whole files in and out: bytes of a regular file, and a file that appears complete or not at all. Failures are FileError.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

// what() is one sentence that names the file.
struct FileError : std::runtime_error {
    enum class Blame { Input, Environment }; // exit code 2 or 3
    Blame blame;
    FileError(Blame whose, const std::string& sentence) : std::runtime_error(sentence), blame(whose) {}
};

constexpr std::size_t kMaxReadBytes = std::size_t{1} << 30; // the largest file that is read whole

std::vector<unsigned char> read_file(const std::string& path);

// Writes beside the target and renames; an existing file is replaced only by a complete one. A symbolic link is followed; a target
// that is no regular file (a terminal, a pipe) is written straight to.
void write_file(const std::string& path, std::span<const unsigned char> bytes);
void write_file(const std::string& path, std::string_view text);

} // namespace lightbench
