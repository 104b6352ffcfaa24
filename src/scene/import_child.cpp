// A forked child with limits. It forks without exec: the child only reads, computes and writes to one descriptor, then leaves by _exit; glibc
// makes malloc usable in the child of a process with threads, and should another lock have been held at that moment, the wall limit ends it.
#include "scene/import_child.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <fmt/format.h>
#include <new>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#if defined(__SANITIZE_ADDRESS__)
#define LIGHTBENCH_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LIGHTBENCH_ADDRESS_SANITIZER 1
#endif
#endif

namespace lightbench::importer {

namespace {

// AddressSanitizer maps terabytes of shadow, so that no limit on address space can hold, and it wants its reports on standard error.
#ifdef LIGHTBENCH_ADDRESS_SANITIZER
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

constexpr int kExitNoMemory = 77, kExitThrew = 78;

std::size_t mapped_now() {
    std::FILE* statm = std::fopen("/proc/self/statm", "re");
    unsigned long pages = 0;
    const bool read = statm && std::fscanf(statm, "%lu", &pages) == 1;
    if (statm) std::fclose(statm);
    return read ? pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) : std::size_t{1} << 32;
}

void set_timer(__itimer_which which, double seconds) {
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(seconds);
    timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - static_cast<double>(timer.it_value.tv_sec)) * 1e6);
    ::setitimer(which, &timer, nullptr);
}

void default_signals() {
    for (const int signal : {SIGPROF, SIGALRM, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGXFSZ})
        if (!kSanitized || signal == SIGPROF || signal == SIGALRM) std::signal(signal, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void be_the_child(const Allowance& allowance, const std::function<void(int)>& job, int out) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    default_signals();
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    if (const int null = kSanitized ? -1 : ::open("/dev/null", O_WRONLY | O_CLOEXEC); null >= 0) ::dup2(null, STDERR_FILENO);
    grant(allowance);
    try {
        job(out);
        ::_exit(0);
    } catch (const std::bad_alloc&) {
        ::_exit(kExitNoMemory);
    } catch (...) {
        ::_exit(kExitThrew);
    }
}

std::optional<std::string> explain(int status) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    if (WIFEXITED(status) && WEXITSTATUS(status) == kExitNoMemory) return "reading it needs far more memory than a file of its size should";
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
        return "reading it takes far more processor time than a file of its size should";
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) return "reading it did not end within the time allowed";
    if (WIFSIGNALED(status)) return fmt::format("its content makes the reader fail (signal {})", WTERMSIG(status));
    return fmt::format("its content makes the reader fail (status {})", WEXITSTATUS(status));
}

} // namespace

// Measured on Assimp 5.2.5: OBJ is read at 8 MB/s and takes 30 bytes of memory a byte of file, the densest ("f 1 2 3") 50; PLY and STL less.
// Twenty times the time covers a slow machine, and the floors what a file of no size takes.
Allowance allowance_for(std::uint64_t input_bytes) {
    constexpr double kMiB = 1024.0 * 1024.0;
    const double size = static_cast<double>(input_bytes);
    const double installed = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    const double cpu = (0.75 + 2.5 * size / kMiB) * (kSanitized ? 10 : 1);
    return {static_cast<std::size_t>(std::min(160 * kMiB + 64 * size, 0.75 * installed)), cpu, 20 + 10 * cpu};
}

void grant(const Allowance& allowance) {
    set_timer(ITIMER_PROF, allowance.cpu_seconds);
    set_timer(ITIMER_REAL, allowance.wall_seconds);
    rlimit space{};
    ::getrlimit(RLIMIT_AS, &space);
    space.rlim_cur = std::min<rlim_t>(mapped_now() + allowance.memory, space.rlim_max);
    if (!kSanitized) ::setrlimit(RLIMIT_AS, &space);
}

ChildOutput::ChildOutput(int memory_file, std::optional<std::string> failure) : why(std::move(failure)) {
    struct stat status {};
    if (why || ::fstat(memory_file, &status) != 0 || status.st_size == 0) return;
    void* mapped = ::mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ, MAP_PRIVATE, memory_file, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    data = static_cast<const std::uint8_t*>(mapped), size = static_cast<std::size_t>(status.st_size);
}

ChildOutput::ChildOutput(ChildOutput&& other) noexcept
    : data(std::exchange(other.data, nullptr)), size(std::exchange(other.size, 0)), why(std::move(other.why)) {}

ChildOutput::~ChildOutput() {
    if (data) ::munmap(const_cast<std::uint8_t*>(data), size);
}

ChildOutput run_in_child(const Allowance& allowance, const std::function<void(int)>& job) {
    const int out = ::memfd_create("import", MFD_CLOEXEC);
    if (out < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
    const pid_t child = ::fork();
    if (child == 0) be_the_child(allowance, job, out);
    const int fork_error = errno;
    int status = 0;
    while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (child < 0) {
        ::close(out);
        throw std::system_error(fork_error, std::generic_category(), "fork");
    }
    ChildOutput output(out, explain(status));
    ::close(out);
    return output;
}

} // namespace lightbench::importer
