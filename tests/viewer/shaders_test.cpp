// Shaders edited while the viewer runs, well and badly: it never ends, says what is wrong where, and shows the last good ones.
#include "screen.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <numeric>

namespace lightbench::viewer {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::HasSubstr;
using Clock = std::chrono::steady_clock;

struct Edit {
    const char* file;
    const char *from, *to;
    const char* place;   // file and line of the error
    const char* message; // part of it
};

// Runs for hours, though every loop ends, and has something to show, so that no compiler may leave it out. Mesa 22.3.6 on the CPU ends all
// loops after 65 535 iterations: those are made to take longer than a trial may.
const Edit kHang = {"lib/phong.glsl", "float c = dot(n, l);",
                    "float c = dot(n, l); for (int j = 0; j < 60000; ++j) for (int i = 0; i < 60000; ++i) for (int k = 0; k < 60000; ++k) "
                    "c = sin(sin(sin(sin(sin(sin(sin(sin(c + float(k))))))))); ",
                    "lib/phong.glsl:0", "a first small picture"};

const Edit kBroken[] = {
    {"lib/phong.glsl", "return c <= 0.0 ? 0.0 : c;", "return c <= 0.0 ? 0.0 : c", "lib/phong.glsl:13", "syntax error"},
    {"lib/phong.glsl", "float c = dot(n, l);", "float c = n;", "lib/phong.glsl:11", "cannot convert"},
    {"lib/phong.glsl", "float c = dot(n, l);", "float c = dott(n, l);", "lib/phong.glsl:11", "'dott'"},
    kHang,
    {"raster/surface.frag", "layout(location = 0) out vec4 color;", "layout(location = 1) out vec4 color;", "raster/surface.frag:0",
     "at location 1: there is none of its type"},
    {"lib/phong.glsl", nullptr, "", "shade.glsl:", "no matching overloaded function"},
    {"lib/phong.glsl", nullptr, nullptr, "shade.glsl:", "lib/phong.glsl"},
    {"lib/phong.glsl", "float c = dot(n, l);", "float c = dot(n, l);\n    while (true) c = sin(c);", "lib/phong.glsl:12", "no way out"},
};

class Edited : public Viewer {
  protected:
    void begin(const std::vector<std::string>& options) {
        if (IsSkipped()) return;
        copy_shaders();
        ::setenv("LIGHTBENCH_SHADERS", (folder / "shaders").c_str(), 1);
        write("scene.toml", ball_scene(160, 120));
        start(options, (folder / "scene.toml").string());
        ::unsetenv("LIGHTBENCH_SHADERS");
        expect("settled");
    }
    void copy_shaders() const {
        if (!fs::exists(folder / "shaders"))
            fs::copy(fs::path(LIGHTBENCH_SOURCE) / "shaders", folder / "shaders", fs::copy_options::recursive);
    }
    // As editors do: beside it, then in its place.
    fs::path write(const fs::path& name, const std::string& text) const {
        std::ofstream(folder / "saved", std::ios::binary) << text;
        fs::rename(folder / "saved", folder / name);
        return folder / name;
    }
    void spoil(const Edit& edit) const {
        const fs::path file = fs::path("shaders") / edit.file;
        if (edit.to == nullptr) {
            fs::remove(folder / file);
            return;
        }
        std::string text = edit.from == nullptr ? "" : read_text(fs::path(LIGHTBENCH_SOURCE) / file);
        if (edit.from != nullptr) {
            const std::size_t at = text.find(edit.from);
            ASSERT_NE(at, std::string::npos) << edit.from;
            text.replace(at, std::string(edit.from).size(), edit.to);
        }
        write(file, text);
    }
    void restore(const Edit& edit) const {
        write(fs::path("shaders") / edit.file, read_text(fs::path(LIGHTBENCH_SOURCE) / "shaders" / edit.file));
    }
    std::string picture() {
        key("F12");
        return read_text(expect("screenshot "));
    }
};

// A good edit whose picture is another one each time.
void brighten(std::string& phong, int i) {
    const std::string from = "return c <= 0.0 ? 0.0 : c;";
    phong.replace(phong.find(from), from.size(), fmt::format("return c <= 0.0 ? 0.0 : {}.0 / 32.0 * c;", 31 - i % 24));
}

TEST_F(Edited, GoodAndBrokenInTurnNeverEndIt) {
    begin({});
    if (IsSkipped()) return;
    const int pairs = std::getenv("LIGHTBENCH_LONG_TESTS") ? 50 : 10;
    std::vector<double> seconds;
    std::string before = picture();
    for (int i = 0; i < pairs; ++i) {
        const Edit& edit = kBroken[static_cast<std::size_t>(i) % std::size(kBroken)];
        forget();
        spoil(edit);
        const std::string error = expect("shader-error ", 20);
        EXPECT_THAT(error, AllOf(HasSubstr((folder / "shaders" / edit.place).string()), HasSubstr(edit.message)));
        EXPECT_EQ(picture() == before, true) << "the last good one stays";
        restore(edit);
        std::string phong = read_text(LIGHTBENCH_SOURCE "/shaders/lib/phong.glsl");
        brighten(phong, i);
        forget();
        const auto saved = Clock::now();
        write("shaders/lib/phong.glsl", phong);
        expect("swapped ", 15);
        seconds.push_back(std::chrono::duration<double>(Clock::now() - saved).count());
        const std::string after = picture();
        EXPECT_NE(after, before) << "edit " << i;
        before = after;
        if (HasFailure()) break;
    }
    std::ranges::sort(seconds);
    fmt::print("from save to swap: median {:.2f} s, slowest {:.2f} s of {}\n", seconds[seconds.size() / 2], seconds.back(), seconds.size());
    EXPECT_LT(seconds[seconds.size() / 2], 3) << "asked: 1 s, where nothing else runs on two cores";
    EXPECT_EQ(quit(), 0);
}

TEST_F(Edited, AFunctionOfOnesOwnHasSlidersThatTheCommandNames) {
    if (IsSkipped()) return;
    const fs::path mine = write("mine.glsl", "const float gain = 0.5; // @slider(0, 2)\n"
                                             "float phong_specular(vec3 n, vec3 l, vec3 v, float shininess) {\n"
                                             "    return gain * original_phong_specular(n, l, v, shininess);\n}\n");
    begin({"--shader", mine.string(), "--slider", "gain=0.25"});
    EXPECT_NE(log().find("swapped raster/surface.frag"), std::string::npos) << "what is settled is drawn with it";
    expect("sliders free", 20);
    const std::string shown = picture();
    key("ctrl+c");
    const std::string line = expect("copied ");
    EXPECT_THAT(line, AllOf(HasSubstr("--shader " + mine.string()), HasSubstr("--slider gain=0.25")));
    const fs::path rendered = folder / "rendered.png";
    const std::string words = line.substr(line.find("render "), line.rfind(" -o ") - line.find("render "));
    const std::string said = output_of(std::string(LIGHTBENCH_PROGRAM) + " " + words + " -o " + rendered.string() + " 2>&1");
    EXPECT_EQ(read_text(rendered), shown) << said;
    forget();
    write("mine.glsl", "float phong_specular(vec3 n, vec3 l, vec3 v, float shininess) {\n    return dot(n, wrong);\n}\n");
    EXPECT_THAT(expect("shader-error "), AllOf(HasSubstr(mine.string() + ":2"), HasSubstr("wrong")));
    EXPECT_EQ(quit(), 0);
}

// Broken and mended while a trial hangs: the trial ends at once.
TEST_F(Edited, ASaveDuringATrialIsSeenAtOnce) {
    begin({});
    if (IsSkipped()) return;
    spoil(kHang);
    expect("shaders: trying");
    std::string phong = read_text(LIGHTBENCH_SOURCE "/shaders/lib/phong.glsl");
    brighten(phong, 5);
    write("shaders/lib/phong.glsl", phong);
    expect("swapped ", 30);
    EXPECT_EQ(log().find("shader-error"), std::string::npos) << "the trial was given up, it did not run out of its time";
    EXPECT_EQ(quit(), 0);
}

TEST_F(Edited, ItEndsAtOnceDuringATrial) {
    begin({});
    if (IsSkipped()) return;
    spoil(kHang);
    expect("shaders: trying");
    const auto start = Clock::now();
    EXPECT_EQ(quit(), 0);
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 30);
    EXPECT_EQ(output_of("pgrep -f '" + folder.filename().string() + ".*lightbench-tria[l]'"), "") << "nobody is left";
}

TEST_F(Edited, AnEditFromBeforeTheStartCounts) {
    if (IsSkipped()) return;
    copy_shaders();
    std::string phong = read_text(LIGHTBENCH_SOURCE "/shaders/lib/phong.glsl");
    brighten(phong, 20);
    write("shaders/lib/phong.glsl", phong);
    begin({});
    EXPECT_NE(log().find("swapped "), std::string::npos);
    const std::string shown = picture();
    key("ctrl+c");
    const std::string line = expect("copied "), rendered = (folder / "rendered.png").string();
    EXPECT_THAT(line, HasSubstr("LIGHTBENCH_SHADERS="));
    const std::string words = line.substr(line.find("render "), line.rfind(" -o ") - line.find("render "));
    const std::string said = output_of("LIGHTBENCH_SHADERS=" + (folder / "shaders").string() + " " + LIGHTBENCH_PROGRAM + " " + words +
                                       " -o " + rendered + " 2>&1");
    EXPECT_EQ(read_text(rendered) == shown, true) << said;
    key("5"); // its shaders are tried now
    expect("swapped raytrace/", 40);
    EXPECT_EQ(quit(), 0);
}

// The first value is quick; the most would hang the viewer itself.
TEST_F(Edited, ASliderThatWouldHangStaysWhereItIs) {
    if (IsSkipped()) return;
    const fs::path mine =
        write("mine.glsl",
              "const float steps = 2.0; // @slider(1, 60000)\n"
              "float lambert(vec3 n, vec3 l) {\n    float c = dot(n, l);\n"
              "    if (steps > 1000.0) for (int j = 0; j < 60000; ++j) for (int i = 0; i < 60000; ++i)\n"
              "        for (int k = 0; k < 60000; ++k) c = sin(sin(sin(sin(sin(sin(sin(sin(c + float(k)))))))));\n    return c;\n}\n");
    begin({"--shader", mine.string()});
    EXPECT_THAT(expect("sliders locked: ", 20), HasSubstr("with steps at 60000, a first small picture, drawn aside,"));
    EXPECT_EQ(quit(), 0);
}

} // namespace
} // namespace lightbench::viewer
