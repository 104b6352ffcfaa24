// Children that answer, fail, hang, close their ears, or are not there.
#include "image/child_process.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using namespace std::chrono_literals;

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

TEST(ChildProcess, MayNotListen) {
    EXPECT_EQ(run_child({"true"}, std::string(1u << 20, 'x'), 10s).code, 0);
}

} // namespace
} // namespace lightbench
