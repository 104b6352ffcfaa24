#include "image/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace lightbench {

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
    Pipe exec; // says a byte if there is no such program
};

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostText = 16u << 20;

// What the child gets: argv as exec wants it, seconds of processor time. Made before the fork, behind which nothing may allocate.
struct Start {
    std::vector<char*> argv;
    rlim_t seconds = 0;
    pid_t parent = 0;

    Start(const std::vector<std::string>& arguments, std::chrono::milliseconds limit) : parent(::getpid()) {
        for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        // Should it outlive us all the same: as much as all processors give within the limit.
        const auto wall = static_cast<rlim_t>(std::chrono::ceil<std::chrono::seconds>(limit).count()) + 1;
        seconds = wall * std::max(1u, std::thread::hardware_concurrency());
    }
};

[[noreturn]] void be_the_child(const Start& start, const Pipes& pipes) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != start.parent) ::_exit(127); // it died before that was said
    ::setpgid(0, 0);                               // a group of its own, to be killed whole
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    ::sigaction(SIGPIPE, &usual, nullptr);
    rlimit time{};
    ::getrlimit(RLIMIT_CPU, &time);
    time.rlim_cur = std::min(time.rlim_max, start.seconds);
    ::setrlimit(RLIMIT_CPU, &time);
    ::dup2(pipes.in.read, STDIN_FILENO), ::dup2(pipes.out.write, STDOUT_FILENO), ::dup2(pipes.err.write, STDERR_FILENO);
    ::execvp(start.argv[0], start.argv.data());
    const char failed = 1;
    if (::write(pipes.exec.write, &failed, 1) != 1) ::_exit(126);
    ::_exit(127);
}

// 0: not started.
pid_t start(const std::vector<std::string>& arguments, std::chrono::milliseconds limit, Pipes& pipes) {
    const Start what(arguments, limit);
    const pid_t child = ::fork();
    if (child == 0) be_the_child(what, pipes);
    pipes.exec.close_write(); // exec closes the child's
    char failed = 0;
    if (child < 0 || ::read(pipes.exec.read, &failed, 1) == 0) return std::max(child, 0);
    ::waitpid(child, nullptr, 0);
    return 0;
}

// When to give up on it.
struct End {
    Clock::time_point time;
    const std::function<bool()>& stop;
    bool stopped = false;
    bool reached() {
        stopped = stopped || (stop && stop());
        return stopped || Clock::now() >= time;
    }
};
constexpr int kLookEvery = 20; // milliseconds

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

// Until both outputs are closed. False: the end was first.
bool exchange(Pipes& pipes, const std::string& in, End& end, ChildResult& result) {
    std::size_t at = 0;
    if (in.empty()) pipes.in.close_write();
    while (pipes.out.read >= 0 || pipes.err.read >= 0) {
        if (end.reached()) return false;
        std::array<pollfd, 3> fds{
            {{pipes.out.read, POLLIN, 0}, {pipes.err.read, POLLIN, 0}, {pipes.in.write, POLLOUT, 0}}}; // of fds below 0 poll says nothing
        if (::poll(fds.data(), fds.size(), kLookEvery) < 0 && errno != EINTR) return false;
        if (fds[0].revents != 0 && !take(pipes.out.read, result.out)) pipes.out.close_read();
        if (fds[1].revents != 0 && !take(pipes.err.read, result.err)) pipes.err.close_read();
        if (fds[2].revents != 0 && !give(pipes.in.write, in, at)) pipes.in.close_write();
    }
    return true;
}

// A child may close its outputs and go on.
bool wait_until(pid_t child, int& status, End& end) {
    while (true) {
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child || (ended < 0 && errno != EINTR)) return true;
        if (end.reached()) return false;
        ::usleep(2000);
    }
}

// The child may have had no time to found its group.
void kill_group(pid_t child) {
    ::kill(-child, SIGKILL), ::kill(child, SIGKILL);
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

struct Child::Parts {
    Pipes pipes;
    pid_t id = 0; // 0: there is none to wait for
};

Child::Child(const std::vector<std::string>& arguments, std::chrono::milliseconds limit) : parts_(std::make_unique<Parts>()) {
    parts_->id = start(arguments, limit, parts_->pipes);
    parts_->pipes.in.close_read(), parts_->pipes.out.close_write(), parts_->pipes.err.close_write();
    ::fcntl(parts_->pipes.in.write, F_SETFL, O_NONBLOCK);
}

Child::Child(Child&&) noexcept = default;

Child::~Child() {
    if (parts_ && parts_->id > 0) kill_group(parts_->id), ::waitpid(parts_->id, nullptr, 0);
}

ChildResult Child::finish(const std::string& in, std::chrono::milliseconds limit, const std::function<bool()>& stop) {
    const IgnorePipeSignal ignored;
    ChildResult result;
    const pid_t child = std::exchange(parts_->id, 0);
    if (child == 0) return result;
    End end{Clock::now() + limit, stop};
    int status = 0;
    const bool ended = exchange(parts_->pipes, in, end, result) && wait_until(child, status, end);
    if (!ended) {
        kill_group(child);
        ::waitpid(child, &status, 0);
        result.stopped = end.stopped, result.timed_out = !end.stopped;
    }
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

ChildResult run_child(const std::vector<std::string>& arguments, const std::string& in, std::chrono::milliseconds limit,
                      const std::function<bool()>& stop) {
    return Child(arguments, limit).finish(in, limit, stop);
}

} // namespace lightbench
