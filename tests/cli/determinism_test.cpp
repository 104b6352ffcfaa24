// The same bytes whatever the number of the driver's threads and the state of the caches (on drivers without these knobs: run after run).
#include "program.h"

#include <fmt/format.h>

namespace lightbench::cli {
namespace {

using Determinism = Cli;

TEST_F(Determinism, TwentyRunsAgreeWhateverTheThreadsAndCaches) {
    const std::string input = fmt::format("{}/assets/scenes/default.toml", LIGHTBENCH_SOURCE), output = in_folder("image.png");
    std::string first;
    for (const char* threads : {"0", "1", "2", "4"})
        for (int i = 0; i < 5; ++i) {
            // The first run of each count finds empty caches, the next ones what it left there.
            const Environment knobs = {{"LP_NUM_THREADS", threads},
                                       {"LIGHTBENCH_CACHE_DIR", in_folder(std::string("pipelines-") + threads)},
                                       {"MESA_SHADER_CACHE_DIR", in_folder(std::string("mesa-") + threads)}};
            const Ran ran = run({"render", input, "-o", output, "--size", "192x108", "--quiet"}, knobs);
            ASSERT_EQ(ran.code, 0) << ran.err;
            if (first.empty()) first = read_text(output);
            ASSERT_EQ(read_text(output) == first, true) << threads << " threads, run " << i;
        }
    EXPECT_GT(first.size(), 1000u);
}

} // namespace
} // namespace lightbench::cli
