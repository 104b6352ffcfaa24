// Shaders of the user's own on the command line: what counts, and what is refused in which words.
#include "program.h"

#include <gmock/gmock.h>

namespace lightbench::cli {
namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;
using ::testing::StartsWith;

class Shaders : public Cli {
  protected:
    Ran render(const std::vector<std::string>& more, const Environment& environment = {}) const {
        std::vector<std::string> words = {"render", scene(kBall), "-o", in_folder("x.png")};
        words.insert(words.end(), more.begin(), more.end());
        return run(words, environment);
    }
    std::string file(const std::string& name, const std::string& text) const {
        write_text(folder / name, text);
        return in_folder(name);
    }
    const std::string black = "float lambert(vec3 n, vec3 l) { return 0.0; }\n";
};

TEST_F(Shaders, TwoFilesWithOneFunctionAreAnError) {
    const std::string a = file("a.glsl", black), b = file("b.glsl", black);
    for (const auto& [first, second] : {std::pair{a, b}, {a, a}}) {
        const Ran ran = render({"--shader", first, "--shader", second});
        EXPECT_EQ(ran.code, 2);
        EXPECT_THAT(ran.err, HasSubstr(fmt::format("lambert is defined in both {} and {}", first, second)));
    }
}

TEST_F(Shaders, AnEditedFolderCounts) {
    fs::copy(fs::path(LIGHTBENCH_SOURCE) / "shaders", folder / "shaders", fs::copy_options::recursive);
    ASSERT_EQ(render({}).code, 0);
    const std::string plain = read_text(folder / "x.png");
    ASSERT_EQ(render({}, {{"LIGHTBENCH_SHADERS", in_folder("shaders")}}).code, 0);
    EXPECT_EQ(read_text(folder / "x.png"), plain) << "a copy is no edit";
    std::string phong = read_text(folder / "shaders/lib/phong.glsl");
    const std::string from = "return c <= 0.0 ? 0.0 : c;";
    phong.replace(phong.find(from), from.size(), "return 0.0 * c;");
    write_text(folder / "shaders/lib/phong.glsl", phong);
    ASSERT_EQ(render({}, {{"LIGHTBENCH_SHADERS", in_folder("shaders")}}).code, 0);
    EXPECT_NE(read_text(folder / "x.png"), plain);
}

TEST_F(Shaders, AFolderThatIsNoneIsAnError) {
    const Ran nowhere = render({}, {{"LIGHTBENCH_SHADERS", "/nope"}});
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_THAT(nowhere.err, StartsWith("LIGHTBENCH_SHADERS: there is no folder /nope"));
    const Ran empty = render({}, {{"LIGHTBENCH_SHADERS", folder.string()}});
    EXPECT_EQ(empty.code, 2);
    EXPECT_THAT(empty.err, HasSubstr("holds no shade.glsl"));
}

TEST_F(Shaders, SlidersSayWhatThereIs) {
    const std::string mine = file("mine.glsl", "const float gain = 0.5; // @slider(0, 1)\n"
                                               "float lambert(vec3 n, vec3 l) { return gain * original_lambert(n, l); }\n");
    EXPECT_THAT(render({"--shader", mine, "--slider", "gian=0.5"}).err,
                HasSubstr("no constant named \"gian\" is marked as a slider; it must be gain"));
    EXPECT_THAT(render({"--shader", mine, "--slider", "gain=0.5,gain=1"}).err, HasSubstr("gain has two values"));
    EXPECT_THAT(render({"--shader", mine, "--slider", "=2"}).err, HasSubstr("\"=2\" must be NAME=NUMBER"));
    EXPECT_EQ(render({"--shader", mine, "--slider", "gain=0.25"}).code, 0);
}

TEST_F(Shaders, NamesOfFilesMayHoldCommas) {
    const std::string odd = file("a,b.glsl", black);
    EXPECT_EQ(render({"--shader", odd}).code, 0);
    EXPECT_THAT(render({"--shader", odd, "--shader", in_folder("no.glsl") + "," + in_folder("none.glsl")}).err,
                HasSubstr("none.glsl: there is no such file"));
}

TEST_F(Shaders, ErrorsHaveNoNoiseBehindThem) {
    const std::string mine = file("mine.glsl", "float lambert(vec3 n, vec3 l) {\n    return dot(n, wrong);\n}\n");
    const Ran ran = render({"--shader", mine});
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, fmt::format("{}:2: 'wrong' : undeclared identifier\n    return dot(n, wrong);\n", mine)) << "this and no more";
}

} // namespace
} // namespace lightbench::cli
