// POSIX calls, so that every failure has its errno and a file is on the disk before it takes its name.
#include "image/file_bytes.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace lightbench {
namespace {

FileError failure(const char* what, const std::string& path, int error) {
    bool wrong_path = error == ENOENT || error == ENOTDIR || error == EISDIR || error == ENAMETOOLONG || error == ELOOP || error == EINVAL;
    return {wrong_path ? FileError::Blame::Input : FileError::Blame::Environment,
            fmt::format("{}: {}: {}", path, what, std::strerror(error))};
}

class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    int get() const { return fd_; }
    int close() { return ::close(std::exchange(fd_, -1)); } // network file systems report a full disk only here

  private:
    int fd_;
};

// The name of a file that is not finished; it is removed unless it was renamed.
class Unfinished {
  public:
    explicit Unfinished(std::string name) : name_(std::move(name)) {}
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
    ~Unfinished() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }
    const char* name() const { return name_.c_str(); }
    void finished() { name_.clear(); }

  private:
    std::string name_;
};

void write_all(int fd, std::span<const unsigned char> bytes, const std::string& path) {
    while (!bytes.empty()) {
        ssize_t n = ::write(fd, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw failure("cannot be written", path, errno);
        bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
}

std::string beside(const std::string& target) {
    static std::atomic<unsigned> count{0}; // two threads that write the same target must not share a name
    std::size_t slash = target.rfind('/');
    std::string folder = slash == std::string::npos ? "" : target.substr(0, slash + 1);
    return fmt::format("{}.unfinished-{}-{}", folder, ::getpid(), count++);
}

// The rename itself must survive a power cut too. A folder that cannot be opened or synchronised (FUSE) still holds the file.
void synchronise_folder_of(const std::string& target) {
    std::size_t slash = target.rfind('/');
    std::string folder = slash == std::string::npos ? "." : target.substr(0, slash + 1);
    Descriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.get() >= 0) ::fsync(fd.get());
}

std::string resolved(const std::string& path) {
    std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
    return real ? real.get() : path;
}

void write_in_place(const std::string& path, std::span<const unsigned char> bytes) {
    Descriptor fd(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (fd.get() < 0) throw failure("cannot be opened for writing", path, errno);
    write_all(fd.get(), bytes, path);
}

} // namespace

std::vector<unsigned char> read_file(const std::string& path) {
    Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)); // a FIFO without a writer must not hang
    if (fd.get() < 0) throw failure("cannot be opened", path, errno);
    struct stat info {};
    if (::fstat(fd.get(), &info) != 0) throw failure("cannot be examined", path, errno);
    if (!S_ISREG(info.st_mode)) throw FileError(FileError::Blame::Input, fmt::format("{}: not a regular file", path));
    auto size = static_cast<std::size_t>(info.st_size);
    if (size > kMaxReadBytes)
        throw FileError(FileError::Blame::Input, fmt::format("{}: {} bytes; the limit is {}", path, size, kMaxReadBytes));
    std::vector<unsigned char> bytes(size);
    std::size_t got = 0;
    while (got < size) {
        ssize_t n = ::read(fd.get(), bytes.data() + got, size - got);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw failure("cannot be read", path, errno);
        if (n == 0) throw FileError(FileError::Blame::Environment, fmt::format("{}: became shorter while it was read", path));
        got += static_cast<std::size_t>(n);
    }
    return bytes;
}

void write_file(const std::string& path, std::span<const unsigned char> bytes) {
    struct stat info {};
    if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode)) return write_in_place(path, bytes);
    std::string target = resolved(path);
    Unfinished file(beside(target));
    Descriptor fd(::open(file.name(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (fd.get() < 0) {
        int error = errno;
        file.finished(); // nothing of ours to remove
        throw failure("cannot be created", path, error);
    }
    write_all(fd.get(), bytes, path);
    if (::fsync(fd.get()) != 0) throw failure("cannot be written", path, errno);
    if (fd.close() != 0) throw failure("cannot be written", path, errno);
    if (::rename(file.name(), target.c_str()) != 0) throw failure("cannot be put in place", path, errno);
    file.finished();
    synchronise_folder_of(target);
}

void write_file(const std::string& path, std::string_view text) {
    write_file(path, std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

} // namespace lightbench
