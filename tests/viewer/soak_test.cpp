// Ten thousand frames under random toggles: memory stays what it was, and nothing is left of the device's objects in the end.
#include "screen.h"

#include <cstdlib>
#include <fstream>
#include <random>

namespace lightbench::viewer {
namespace {

class Soak : public Viewer {
  protected:
    std::string scene() const {
        write_text(folder / "scene.toml", ball_scene(96, 72, "", "texture = { checker = true }\n"));
        return (folder / "scene.toml").string();
    }
    // The last of "frames N".
    unsigned long frames() const {
        const std::string text = log();
        const std::size_t at = text.rfind("frames ");
        return at == std::string::npos ? 0 : std::stoul(text.substr(at + 7));
    }
    // MiB that are in memory.
    double resident() const {
        const std::string pid = output_of("pgrep -f -o 'view .*" + folder.filename().string() + "'");
        std::ifstream statm("/proc/" + pid.substr(0, pid.find('\n')) + "/statm");
        double all = 0, pages = 0;
        statm >> all >> pages;
        return pages * 4096 / (1 << 20);
    }
    // Presses keys at random until so many frames have been drawn.
    void toggle_until(unsigned long last) {
        const char* const keys[] = {"1", "2", "3", "t", "x", "n", "h", "c", "Tab", "z", "y"};
        while (frames() < last && !HasFailure()) {
            std::string words = "key --delay 8";
            for (int i = 0; i < 200; ++i) words += fmt::format(" {}", keys[random() % std::size(keys)]);
            tool(words);
            if (++batches > 5000) FAIL() << "no frames are drawn";
            if (frames() == noted) continue;
            noted = frames(), course += fmt::format(" {:.1f}", resident());
        }
    }
    // Of what is resident meanwhile: it goes up and down with the variants that happen to be shown.
    double mean_until(unsigned long last) {
        double sum = 0;
        int samples = 0;
        for (unsigned long next = frames() + 200; next <= last; next += 200) toggle_until(next), sum += resident(), ++samples;
        return sum / samples;
    }
    std::mt19937 random{11};
    int batches = 0;
    unsigned long noted = 0;
    std::string course;
};

TEST_F(Soak, TenThousandFramesLeaveMemoryAsItWas) {
    if (IsSkipped()) return;
    if (std::getenv("LIGHTBENCH_LONG_TESTS") == nullptr) GTEST_SKIP() << "LIGHTBENCH_LONG_TESTS is not set";
    // Without validation: what its layers remember of each object grows by 0.3 MiB a thousand toggles.
    start({}, scene(), false);
    toggle_until(6000); // each variant has been used, on each side
    const double before = mean_until(8000);
    toggle_until(16000);
    const double after = mean_until(18000);
    fmt::print("resident: {:.1f} MiB about frame 7000, {:.1f} MiB about frame 17000: {:+.2f} %\nMiB on the way:{}\n", before, after,
               100 * (after / before - 1), course);
    EXPECT_GT(before, 50);
    EXPECT_LT(after, 1.01 * before);
    EXPECT_EQ(quit(), 0);
}

TEST_F(Soak, ThousandsOfFramesLeaveNoObject) {
    if (IsSkipped()) return;
    if (std::getenv("LIGHTBENCH_LONG_TESTS") == nullptr) GTEST_SKIP() << "LIGHTBENCH_LONG_TESTS is not set";
    start({}, scene());
    toggle_until(10000);
    EXPECT_EQ(quit(), 0) << "validation had something to say, perhaps of objects that are left";
}

} // namespace
} // namespace lightbench::viewer
