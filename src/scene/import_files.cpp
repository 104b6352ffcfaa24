// Reads whole files within limits, and keeps references inside the scene's folder.
#include "scene/import_files.h"

#include "scene/limits.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lightbench {

namespace {

struct Descriptor {
    int fd;
    explicit Descriptor(const std::filesystem::path& file) : fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
};

bool is_inside(const std::filesystem::path& file, const std::filesystem::path& root) {
    const auto [in_root, in_file] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    return in_root == root.end() || (in_root->empty() && std::next(in_root) == root.end());
}

} // namespace

std::variant<Bytes, std::string> read_whole_file(const std::filesystem::path& file) {
    const Descriptor in(file);
    struct stat status {};
    if (in.fd < 0 || ::fstat(in.fd, &status) != 0) return fmt::format("cannot be read: {}", std::strerror(errno));
    if (S_ISDIR(status.st_mode)) return "is a folder, not a file";
    if (!S_ISREG(status.st_mode)) return "is not a regular file";
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > limits::kMaxFileBytes) return fmt::format("has {} bytes; the limit is {}", size, limits::kMaxFileBytes);
    Bytes bytes(size);
    for (std::size_t done = 0; done < size;) {
        const ssize_t got = ::read(in.fd, bytes.data() + done, size - done);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return fmt::format("cannot be read: {}", got == 0 ? "it became shorter meanwhile" : std::strerror(errno));
        done += static_cast<std::size_t>(got);
    }
    return bytes;
}

Resolved resolve(const Surroundings& around, std::string_view name) {
    namespace fs = std::filesystem;
    std::string text(name);
    std::error_code error;
    if (text.empty() || text.find('\0') != text.npos) return {};
    fs::path file = fs::canonical(around.folder / text, error);
    if (error) {
        std::replace(text.begin(), text.end(), '\\', '/');
        file = fs::canonical(around.folder / text, error);
    }
    if (error || !fs::exists(file, error)) return {};
    if (around.allow_outside || is_inside(file, fs::canonical(around.root, error))) return {Reference::found, around.folder / text};
    return {Reference::outside, file};
}

} // namespace lightbench
