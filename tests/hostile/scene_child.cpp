// Fork, load, report through a pipe; the parent measures by wait4 and ends what does not end.
#include "hostile/scene_child.h"

#include <chrono>
#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lightbench::hostile {
namespace {

constexpr auto kPatience =
    std::chrono::seconds(30); // wall time, generous: the machine may be busy; the bound that counts is processor time

double peak_megabytes(int who) {
    rusage usage{};
    ::getrusage(who, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

[[noreturn]] void child(const std::function<Loaded()>& load, int out) {
    ::signal(SIGALRM, SIG_DFL);
    ::alarm(static_cast<unsigned>(kPatience.count()));
    const double before = peak_megabytes(RUSAGE_SELF);
    std::string text;
    bool accepted = false;
    {
        const Loaded loaded = load();
        accepted = loaded.scene.has_value();
        for (const Problem& problem : loaded.problems) text += to_string(problem) + "\n";
    }
    text += std::to_string(peak_megabytes(RUSAGE_SELF) - before);
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t n = ::write(out, text.data() + done, text.size() - done);
        if (n <= 0) break;
        done += static_cast<std::size_t>(n);
    }
    ::_exit(accepted ? 10 : 11);
}

std::string read_to_end(int fd) {
    std::string text;
    char buffer[4096];
    for (ssize_t n; (n = ::read(fd, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(n));
    ::close(fd);
    return text;
}

} // namespace

Outcome load_in_child(const std::function<Loaded()>& load) {
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    const pid_t pid = ::fork();
    if (pid == 0) {
        ::close(ends[0]);
        child(load, ends[1]);
    }
    ::close(ends[1]);
    Outcome outcome;
    outcome.report = read_to_end(ends[0]);
    int status = 0;
    rusage usage{};
    ::wait4(pid, &status, 0, &usage);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    outcome.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    outcome.ended = WIFEXITED(status) && (WEXITSTATUS(status) == 10 || WEXITSTATUS(status) == 11);
    outcome.accepted = outcome.ended && WEXITSTATUS(status) == 10;
    const std::size_t last = outcome.report.rfind('\n') + 1; // npos + 1 is 0
    if (outcome.ended) outcome.megabytes = std::stod(outcome.report.substr(last));
    outcome.report.erase(last);
    return outcome;
}

Outcome load_in_child(const std::filesystem::path& file) {
    return load_in_child([&] { return load_scene(file); });
}

void expect_refused(const Outcome& outcome, const std::string& reason) {
    EXPECT_TRUE(outcome.ended) << "crashed or did not end";
    EXPECT_FALSE(outcome.accepted);
    EXPECT_THAT(outcome.report, testing::HasSubstr(reason));
    EXPECT_LT(outcome.cpu_seconds, kMaxSeconds);
    EXPECT_LT(outcome.megabytes, kMaxMegabytes);
}

} // namespace lightbench::hostile
