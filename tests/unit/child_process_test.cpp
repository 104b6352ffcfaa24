// Children that answer, fail, hang, close their ears, or are not there.
#include "image/child_process.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lightbench {
namespace {

using namespace std::chrono_literals;

// Dead, though nobody has asked for its exit code yet.
bool ended(pid_t process) {
    std::ifstream file(fmt::format("/proc/{}/stat", process));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return text.empty() || text.find(") Z") != text.npos;
}

TEST(ChildProcess, AnswersWhatItReads) {
    const std::string text(1u << 20, 'x');
    const ChildResult cat = run_child({"cat"}, text, 10s);
    EXPECT_EQ(cat.code, 0);
    EXPECT_EQ(cat.out, text);
    EXPECT_EQ(cat.err, "");
}

TEST(ChildProcess, TellsExitCodesSignalsAndErrors) {
    const ChildResult failed = run_child({"sh", "-c", "echo out; echo err >&2; exit 7"}, "", 10s);
    EXPECT_EQ(failed.code, 7);
    EXPECT_EQ(failed.out, "out\n");
    EXPECT_EQ(failed.err, "err\n");
    EXPECT_EQ(run_child({"sh", "-c", "kill -TERM $$"}, "", 10s).code, 128 + 15);
    EXPECT_FALSE(run_child({"/nowhere/at/all"}, "", 10s).started());
}

TEST(ChildProcess, EndsWithItsTime) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(run_child({"sh", "-c", "sleep 60 & sleep 60"}, "", 200ms).timed_out);
    EXPECT_TRUE(run_child({"sh", "-c", "exec >&- 2>&-; sleep 60"}, "", 200ms).timed_out) << "outputs closed";
    EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
}

TEST(ChildProcess, EndsSoonOnceItIsNotWanted) {
    const auto start = std::chrono::steady_clock::now();
    const auto stop = [&] { return std::chrono::steady_clock::now() - start > 100ms; };
    const ChildResult stopped = run_child({"sh", "-c", "sleep 60 & sleep 60"}, "", 60s, stop);
    EXPECT_TRUE(stopped.stopped && !stopped.timed_out);
    EXPECT_TRUE(run_child({"sh", "-c", "exec >&- 2>&-; sleep 60"}, "", 60s, stop).stopped) << "outputs closed";
    EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
}

TEST(ChildProcess, WaitsForItsInputBesideOthers) {
    Child first({"sh", "-c", "read a; echo first $a"}, 10s);
    Child second({"sh", "-c", "read a; echo second $a"}, 10s);
    EXPECT_EQ(run_child({"echo", "third"}, "", 10s).out, "third\n");
    EXPECT_EQ(second.finish("b\n", 10s).out, "second b\n");
    EXPECT_EQ(first.finish("a\n", 10s).out, "first a\n");
    EXPECT_FALSE(Child({"/nowhere/at/all"}, 10s).finish("", 10s).started());
}

TEST(ChildProcess, EndsWhenNobodyWantsIt) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    std::array<char, 16> text{};
    {
        const Child child({"sh", "-c", fmt::format("echo $$ >&{}; exec sleep 60", ends[1])}, 60s);
        ASSERT_GT(::read(ends[0], text.data(), text.size() - 1), 0);
        EXPECT_FALSE(ended(std::atoi(text.data())));
    }
    EXPECT_TRUE(ended(std::atoi(text.data())));
    ::close(ends[0]), ::close(ends[1]);
}

// A program that is killed leaves nobody behind.
TEST(ChildProcess, DiesWithItsParent) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        run_child({"sh", "-c", fmt::format("echo $$ >&{}; exec sleep 60", ends[1])}, "", 60s);
        ::_exit(0);
    }
    std::array<char, 32> text{};
    ASSERT_GT(::read(ends[0], text.data(), text.size() - 1), 0);
    const pid_t child = std::atoi(text.data());
    ASSERT_GT(child, 0);
    EXPECT_EQ(::kill(child, 0), 0);
    ::kill(parent, SIGKILL), ::waitpid(parent, nullptr, 0);
    for (int i = 0; i < 200 && ::kill(child, 0) == 0 && !ended(child); ++i) ::usleep(10000);
    EXPECT_TRUE(::kill(child, 0) != 0 || ended(child));
    ::close(ends[0]), ::close(ends[1]);
}

TEST(ChildProcess, MayNotListen) {
    EXPECT_EQ(run_child({"true"}, std::string(1u << 20, 'x'), 10s).code, 0);
}

} // namespace
} // namespace lightbench
