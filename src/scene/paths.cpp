// Path resolution by canonical prefix, and guarded reading through POSIX calls.
#include "scene/paths.h"

#include "scene/problem_log.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lightbench {
namespace fs = std::filesystem;
namespace {

const char* kind_of(mode_t mode) {
    if (S_ISDIR(mode)) return "a directory";
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

std::string not_regular(mode_t mode) {
    return fmt::format("it is {}; it must be a regular file", kind_of(mode));
}

bool begins_with(const fs::path& path, const fs::path& prefix) {
    return std::mismatch(prefix.begin(), prefix.end(), path.begin(), path.end()).first == prefix.end();
}

// Owns a file descriptor.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    int get() const { return fd_; }

  private:
    int fd_;
};

std::string reason(int error) {
    return error == ENOENT ? "there is no such file" : std::strerror(error);
}

std::string too_large(std::size_t limit, std::string_view limit_name) {
    return fmt::format("the file is larger than {} bytes (limit {})", limit, limit_name);
}

Bytes read_all(int fd, std::size_t expected, std::size_t limit, std::string_view limit_name) {
    std::string text;
    std::size_t used = 0;
    text.resize(expected + 1); // one more byte, so that the end of a file of the expected size is seen by the first round
    while (true) {
        const ssize_t got = ::read(fd, text.data() + used, text.size() - used);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return {{}, reason(errno)};
        if (got == 0) break;
        used += static_cast<std::size_t>(got);
        if (used > limit) return {{}, too_large(limit, limit_name)};
        if (used == text.size()) text.resize(std::min(limit + 1, used * 2));
    }
    text.resize(used);
    return {std::move(text), {}};
}

} // namespace

fs::path folder_of(const fs::path& file) {
    const fs::path parent = file.parent_path();
    return parent.empty() ? fs::path(".") : parent;
}

Resolved resolve_file(const fs::path& folder, std::string_view name, bool allow_outside) {
    const std::string outside = "it lies outside the scene's folder; move it into the folder or give --allow-outside";
    if (name.empty()) return {{}, "the name is empty; it must name a file"};
    if (name.find('\0') != name.npos) return {{}, "the name holds a NUL byte; it must name a file"};
    const fs::path asked(name);
    const fs::path plain = asked.lexically_normal();
    // Told before the disk is asked, so that a scene cannot find out which files exist elsewhere.
    const bool leaves = asked.is_absolute() || (!plain.empty() && *plain.begin() == "..");
    if (leaves && !allow_outside) return {{}, outside};
    std::error_code error;
    const fs::path path = folder / asked;
    const fs::path real = fs::canonical(path, error);
    if (error) return {{}, reason(error.value())};
    const fs::path root = fs::canonical(folder, error);
    if (error) return {{}, reason(error.value())};
    if (!allow_outside && !begins_with(real, root)) return {{}, outside};
    struct stat info {};
    if (::stat(real.c_str(), &info) != 0) return {{}, reason(errno)};
    if (!S_ISREG(info.st_mode)) return {{}, not_regular(info.st_mode)};
    return {path, {}};
}

Bytes read_file(const fs::path& file, std::size_t limit, std::string_view limit_name) {
    const Descriptor fd(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (fd.get() < 0) return {{}, reason(errno)};
    struct stat info {};
    if (::fstat(fd.get(), &info) != 0) return {{}, reason(errno)};
    if (!S_ISREG(info.st_mode)) return {{}, not_regular(info.st_mode)};
    const auto size = static_cast<std::size_t>(info.st_size);
    if (size > limit) return {{}, too_large(limit, limit_name)};
    return read_all(fd.get(), size, limit, limit_name);
}

} // namespace lightbench
