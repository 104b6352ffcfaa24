// The same bytes whatever the number of the driver's threads and the state of the caches (on drivers without these knobs: run after run).
#include "program.h"

#include <fmt/format.h>

namespace lightbench::cli {
namespace {

using Determinism = Cli;

// The first run of each count of threads finds empty caches, the next ones what it left there.
Environment knobs_for(const std::string& threads, const std::string& pipelines, const std::string& mesa) {
    return {{"LP_NUM_THREADS", threads}, {"LIGHTBENCH_CACHE_DIR", pipelines}, {"MESA_SHADER_CACHE_DIR", mesa}};
}

TEST_F(Determinism, TwentyRunsAgreeWhateverTheThreadsAndCaches) {
    const std::string input = fmt::format("{}/assets/scenes/default.toml", LIGHTBENCH_SOURCE), output = in_folder("image.png");
    std::string first;
    for (const std::string threads : {"0", "1", "2", "4"})
        for (int i = 0; i < 5; ++i) {
            const Environment knobs = knobs_for(threads, in_folder("pipelines-" + threads), in_folder("mesa-" + threads));
            const Ran ran = run({"render", input, "-o", output, "--size", "192x108", "--quiet"}, knobs);
            ASSERT_EQ(ran.code, 0) << ran.err;
            if (first.empty()) first = read_text(output);
            ASSERT_EQ(read_text(output) == first, true) << threads << " threads, run " << i;
        }
    EXPECT_GT(first.size(), 1000u);
}

// Rays: which of them lie where in the buffers depends on the order in which threads get there, and nothing may depend on that.
TEST_F(Determinism, TracedPicturesAgreeWhateverTheThreadsAndCaches) {
    const std::string frosted = fmt::format("{}/assets/scenes/frosted.toml", LIGHTBENCH_SOURCE),
                      mirrors = fmt::format("{}/assets/scenes/mirrors.toml", LIGHTBENCH_SOURCE), output = in_folder("image.exr");
    const std::vector<std::vector<std::string>> pictures = {{frosted, "--sampling", "jittered", "--spp", "4", "--filter", "gaussian"},
                                                            {mirrors, "--sampling", "adaptive", "--depth", "8"}};
    for (const auto& picture : pictures) {
        std::string first;
        for (const std::string threads : {"0", "1", "2", "4"})
            for (int i = 0; i < 2; ++i) {
                const Environment knobs = knobs_for(threads, in_folder("pipelines-" + threads), in_folder("mesa-" + threads));
                std::vector<std::string> arguments = {"render", "-o", output, "--method", "raytrace", "--size", "96x54", "--quiet"};
                arguments.insert(arguments.end(), picture.begin(), picture.end());
                const Ran ran = run(arguments, knobs);
                ASSERT_EQ(ran.code, 0) << ran.err;
                if (first.empty()) first = read_text(output);
                ASSERT_EQ(read_text(output) == first, true) << picture.front() << ", " << threads << " threads, run " << i;
            }
        EXPECT_GT(first.size(), 1000u);
    }
}

} // namespace
} // namespace lightbench::cli
