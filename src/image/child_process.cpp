#include "image/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace lightbench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostText = 16u << 20;

// Both ends close by themselves, so that nothing leaks into a child that another thread starts meanwhile.
struct Pipe {
    int read = -1, write = -1;
    Pipe() {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) == 0) read = ends[0], write = ends[1];
    }
    Pipe(const Pipe&) = delete;
    ~Pipe() { close_read(), close_write(); }
    void close_read() {
        if (read >= 0) ::close(std::exchange(read, -1));
    }
    void close_write() {
        if (write >= 0) ::close(std::exchange(write, -1));
    }
};

struct Pipes {
    Pipe in, out, err;
};

// 0: not started.
pid_t start(const std::vector<std::string>& arguments, const Pipes& pipes) {
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipes.in.read, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipes.out.write, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipes.err.write, STDERR_FILENO);
    posix_spawnattr_t attributes{};
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP); // a group of its own, to be killed whole
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    pid_t child = 0;
    const int error = ::posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error == 0 ? child : 0;
}

// Reads what there is. False: the other side has closed.
bool take(int fd, std::string& text) {
    std::array<char, 65536> buffer{};
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got > 0 && text.size() < kMostText) text.append(buffer.data(), static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && errno == EINTR);
}

// Writes what fits. False: all is written, or nobody reads.
bool give(int fd, const std::string& text, std::size_t& at) {
    const ssize_t put = ::write(fd, text.data() + at, std::min<std::size_t>(text.size() - at, 65536));
    if (put > 0) at += static_cast<std::size_t>(put);
    return (put >= 0 || errno == EINTR || errno == EAGAIN) && at < text.size();
}

// Until both outputs are closed. False: the time was over first.
bool exchange(Pipes& pipes, const std::string& in, Clock::time_point end, ChildResult& result) {
    std::size_t at = 0;
    if (in.empty()) pipes.in.close_write();
    while (pipes.out.read >= 0 || pipes.err.read >= 0) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return false;
        std::array<pollfd, 3> fds{
            {{pipes.out.read, POLLIN, 0}, {pipes.err.read, POLLIN, 0}, {pipes.in.write, POLLOUT, 0}}}; // of fds below 0 poll says nothing
        if (::poll(fds.data(), fds.size(), static_cast<int>(std::min<long long>(left, 1000))) < 0 && errno != EINTR) return false;
        if (fds[0].revents != 0 && !take(pipes.out.read, result.out)) pipes.out.close_read();
        if (fds[1].revents != 0 && !take(pipes.err.read, result.err)) pipes.err.close_read();
        if (fds[2].revents != 0 && !give(pipes.in.write, in, at)) pipes.in.close_write();
    }
    return true;
}

// A child may close its outputs and go on.
bool wait_until(pid_t child, int& status, Clock::time_point end) {
    while (true) {
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child || (ended < 0 && errno != EINTR)) return true;
        if (Clock::now() >= end) return false;
        ::usleep(2000);
    }
}

// A reader that ends early must not end us: its write is an error instead of a signal.
struct IgnorePipeSignal {
    struct sigaction before {};
    IgnorePipeSignal() {
        struct sigaction ignore {};
        ignore.sa_handler = SIG_IGN;
        ::sigaction(SIGPIPE, &ignore, &before);
    }
    IgnorePipeSignal(const IgnorePipeSignal&) = delete;
    ~IgnorePipeSignal() { ::sigaction(SIGPIPE, &before, nullptr); }
};

} // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const std::string& in, std::chrono::milliseconds limit) {
    const IgnorePipeSignal ignored;
    ChildResult result;
    Pipes pipes;
    const Clock::time_point end = Clock::now() + limit;
    const pid_t child = start(arguments, pipes);
    if (child == 0) return result;
    pipes.in.close_read(), pipes.out.close_write(), pipes.err.close_write();
    ::fcntl(pipes.in.write, F_SETFL, O_NONBLOCK);
    int status = 0;
    result.timed_out = !exchange(pipes, in, end, result) || !wait_until(child, status, end);
    if (result.timed_out) {
        ::kill(-child, SIGKILL);
        ::waitpid(child, &status, 0);
    }
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

} // namespace lightbench
