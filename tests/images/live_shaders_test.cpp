// Shaders that are edited: what depends on what, errors where they were made, and what does not fit refused before it can do harm.
#include "image/child_process.h"
#include "render/live/endless.h"
#include "render/live/fits.h"
#include "render/live/shader_tree.h"
#include "render/shaders.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>

namespace lightbench {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

// A copy of shaders/ to be spoilt.
class LiveShaders : public testing::Test {
  protected:
    void SetUp() override {
        if (!run_child({"glslangValidator", "--version"}, "", std::chrono::seconds(5)).started()) GTEST_SKIP() << "no glslangValidator";
        std::string name = (fs::temp_directory_path() / "lightbench-live-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
        fs::copy(fs::path(LIGHTBENCH_SOURCE) / "shaders", folder / "shaders", fs::copy_options::recursive);
    }
    void TearDown() override {
        if (!folder.empty()) fs::remove_all(folder);
    }

    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
        return folder / name;
    }
    void edit(const std::string& name, const std::string& from, const std::string& to) const {
        std::ifstream in(folder / "shaders" / name);
        std::string text{std::istreambuf_iterator<char>(in), {}};
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        write("shaders/" + name, text.replace(at, from.size(), to));
    }
    fs::path folder;
};

TEST_F(LiveShaders, TellWhatDependsOnAFile) {
    ShaderTree tree(folder / "shaders");
    EXPECT_THAT(tree.refresh(), IsEmpty());
    edit("lib/phong.glsl", "float nl", "float  nl");
    const auto changed = tree.refresh();
    EXPECT_THAT(changed, ElementsAre("lib/phong.glsl"));
    const auto names = tree.dependents(changed);
    EXPECT_THAT(names, AllOf(Contains("raster/surface.frag"), Contains("raytrace/shade.comp"), Not(Contains("display/display.comp"))));
    fs::remove(folder / "shaders/lib/phong.glsl");
    EXPECT_THAT(tree.refresh(), ElementsAre("lib/phong.glsl"));
    EXPECT_EQ(tree.dependents(std::vector<std::string>{"lib/phong.glsl"}), names);
}

TEST_F(LiveShaders, MustHaveAWayOutOfEachLoop) {
    ShaderTree tree(folder / "shaders");
    const auto message_of = [&](const std::string& loop) {
        fs::copy(fs::path(LIGHTBENCH_SOURCE) / "shaders/lib/phong.glsl", folder / "shaders/lib/phong.glsl",
                 fs::copy_options::overwrite_existing);
        edit("lib/phong.glsl", "float c = dot(n, l);", "float c = dot(n, l);\n    " + loop);
        tree.refresh();
        const auto compiled = tree.compile({"raster/surface.frag", "raster/shade_points.comp"});
        std::string all;
        for (const ShaderError& error : compiled.errors) all += to_string(error) + "\n";
        return all;
    };
    for (const char* endless : {"while (true) c = sin(c);", "for (;;) for (int i = 0; i < 9; ++i) c += 1.0;",
                                "do { if (c > 2.0) continue; c += 1.0; } while (1 > 0);"})
        EXPECT_EQ(message_of(endless),
                  fmt::format("{}:12: this loop has no way out\n    {}\n", (folder / "shaders/lib/phong.glsl").string(), endless));
    for (const char* fine : {"while (true) { c += 1.0; if (c > 9.0) break; }", "for (;;) { if (c > 9.0) return c; c += 1.0; }",
                             "while (false) c = sin(c);", "while (c > 0.0) c = abs(c);"})
        EXPECT_EQ(message_of(fine), "");
}

TEST(EndlessLoops, AreInNoneOfTheProgramsShaders) {
    for (const gpu::ShaderCode& code : lightbench_shaders_table()) EXPECT_FALSE(endless_loop(code.words)) << code.name;
}

TEST_F(LiveShaders, CompileToWhatTheProgramHas) {
    const ShaderTree tree(folder / "shaders");
    const auto compiled = tree.compile({"raster/surface.frag", "display/display.comp"});
    EXPECT_THAT(compiled.errors, IsEmpty());
    ASSERT_EQ(compiled.modules.size(), 2u);
    const auto own = find_shader("raster/surface.frag").words;
    EXPECT_TRUE(std::ranges::equal(compiled.modules.at("raster/surface.frag"), own));
}

TEST_F(LiveShaders, ErrorsStandWhereTheyWereMade) {
    edit("lib/phong.glsl", "float nl = dot(n, l);", "float nl = dot(n, l) + nothing;");
    const auto compiled = ShaderTree(folder / "shaders").compile({"raster/surface.frag", "raytrace/light.comp", "display/display.comp"});
    ASSERT_FALSE(compiled.errors.empty());
    EXPECT_EQ(std::ranges::count(compiled.errors, compiled.errors[0].message, &ShaderError::message), 1)
        << "once, though in two entry points";
    EXPECT_EQ(compiled.errors[0].file, (folder / "shaders/lib/phong.glsl").string());
    EXPECT_EQ(compiled.errors[0].text, "float nl = dot(n, l) + nothing;");
    EXPECT_THAT(compiled.errors[0].message, HasSubstr("'nothing'"));
    EXPECT_EQ(compiled.modules.count("display/display.comp"), 1u);
}

TEST_F(LiveShaders, WhatIsGoneOrEmptyOrNoTextIsAnError) {
    fs::remove(folder / "shaders/display/display.comp");
    write("shaders/raster/surface.frag", "");
    write("shaders/raster/surface.vert", std::string("\0\xff\xfe{{{{", 7));
    fs::remove(folder / "shaders/lib/sum.glsl");
    const auto compiled = ShaderTree(folder / "shaders")
                              .compile({"display/display.comp", "raster/surface.frag", "raster/surface.vert", "raytrace/light.comp"});
    EXPECT_THAT(compiled.modules, IsEmpty());
    const auto error = [](const char* file, const char* message) {
        return AllOf(Field(&ShaderError::file, EndsWith(file)), Field(&ShaderError::message, HasSubstr(message)));
    };
    EXPECT_THAT(compiled.errors, UnorderedElementsAre(error("display/display.comp", "is gone"), error("raster/surface.frag", "is empty"),
                                                      error("raster/surface.vert", "zero byte in line 1"), error(".glsl", "lib/sum.glsl")));
}

TEST_F(LiveShaders, EditedFilesAreToldFromThoseOfTheProgram) {
    ShaderTree tree(folder / "shaders");
    EXPECT_THAT(tree.edited(), IsEmpty());
    edit("lib/phong.glsl", "float nl", "float  nl");
    fs::remove(folder / "shaders/lib/sum.glsl");
    write("shaders/lib/mine.glsl", "");
    EXPECT_TRUE(tree.is_stale());
    tree.refresh();
    EXPECT_FALSE(tree.is_stale());
    EXPECT_THAT(tree.edited(), UnorderedElementsAre("lib/phong.glsl", "lib/sum.glsl", "lib/mine.glsl"));
}

TEST_F(LiveShaders, CirclesAndRecursionAreToldWhereTheyAre) {
    write("shaders/lib/mine.glsl", "\n#include \"lib/mine.glsl\"\n");
    edit("lib/phong.glsl", "#include \"lib/power.glsl\"", "#include \"lib/power.glsl\"\n#include \"lib/mine.glsl\"");
    const auto start = std::chrono::steady_clock::now();
    const auto circle = ShaderTree(folder / "shaders").compile({"raster/surface.frag", "raytrace/light.comp"});
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));
    ASSERT_EQ(circle.errors.size(), 1u);
    EXPECT_EQ(circle.errors[0].file, (folder / "shaders/lib/mine.glsl").string());
    EXPECT_EQ(circle.errors[0].line, 2u);
    EXPECT_EQ(circle.errors[0].message, "includes itself");
    write("shaders/lib/mine.glsl", "");
    edit("lib/phong.glsl", "float c = dot(n, l);", "float c = dot(n, l) + lambert(l, n);");
    const auto recursive = ShaderTree(folder / "shaders").compile({"raster/surface.frag", "raytrace/light.comp"});
    ASSERT_EQ(recursive.errors.size(), 1u);
    EXPECT_EQ(recursive.errors[0].file, (folder / "shaders/lib/phong.glsl").string());
    EXPECT_EQ(recursive.errors[0].message, "lambert calls itself: GLSL has no recursion");
}

TEST_F(LiveShaders, FilesBesideTheUsersAreIncludedAndWatched) {
    fs::create_directories(folder / "own/parts");
    write("own/parts/more.glsl", "float more() { return 0.5; }\n");
    write("own/helper.glsl", "#include \"parts/more.glsl\"\n");
    const fs::path mine = write("own/mine.glsl", "#include \"helper.glsl\"\n#include \"lib/power.glsl\"\n"
                                                 "float lambert(vec3 n, vec3 l) { return more(); }\r\n");
    ShaderTree tree(folder / "shaders", {mine});
    EXPECT_THAT(tree.compile({"raster/surface.frag"}).errors, IsEmpty());
    write("own/parts/more.glsl", "float more() { return wrong; }\n");
    const auto changed = tree.refresh();
    EXPECT_THAT(changed, ElementsAre("user/0/parts/more.glsl"));
    EXPECT_THAT(tree.dependents(changed), Contains("raster/surface.frag"));
    const auto broken = tree.compile({"raster/surface.frag"});
    ASSERT_FALSE(broken.errors.empty());
    EXPECT_EQ(broken.errors[0].file, (folder / "own/parts/more.glsl").string());
}

TEST_F(LiveShaders, FilesThatCannotBeReadSayWhy) {
    const fs::path mine = write("mine.glsl", "float lambert(vec3 n, vec3 l) { return 0.5; }\n");
    ShaderTree tree(folder / "shaders", {mine});
    const auto message = [&] {
        tree.refresh();
        const auto errors = tree.compile({"raster/surface.frag"}).errors;
        return errors.size() == 1 ? errors[0].message : fmt::format("{} errors", errors.size());
    };
    fs::remove(mine);
    EXPECT_EQ(message(), "is gone");
    fs::create_directory(mine);
    EXPECT_THAT(message(), HasSubstr("is a folder"));
    fs::remove(mine);
    write("mine.glsl", std::string(5u << 20, ' '));
    EXPECT_EQ(message(), "is larger than 4 MiB");
    write("mine.glsl", "");
    EXPECT_THAT(message(), HasSubstr("is empty"));
}

TEST_F(LiveShaders, SlidersInFilesWithWindowsLineEnds) {
    const std::string rest = "\r\nfloat lambert(vec3 n, vec3 l) {\r\n    return k;\r\n}\r\n";
    const fs::path mine = write("mine.glsl", "const float k = 1.0; // @slider(0, 2)" + rest);
    const auto good = ShaderTree(folder / "shaders", {mine}).compile({"raster/surface.frag"});
    EXPECT_THAT(good.errors, IsEmpty());
    EXPECT_EQ(good.sliders.size(), 1u);
    write("mine.glsl", "const float k = 1.0; // @slider(0, 2, 0.5)" + rest);
    const auto wrong = ShaderTree(folder / "shaders", {mine}).compile({"raster/surface.frag"});
    ASSERT_EQ(wrong.errors.size(), 1u);
    EXPECT_EQ(wrong.errors[0].file, mine.string());
    EXPECT_EQ(wrong.errors[0].line, 1u);
}

TEST_F(LiveShaders, CompilingStopsWhenAsked) {
    const auto compiled = ShaderTree(folder / "shaders").compile({"raytrace/shade.comp"}, std::chrono::seconds(20), [] { return true; });
    EXPECT_TRUE(compiled.stopped);
}

TEST_F(LiveShaders, WhatDoesNotFitIsRefused) {
    edit("display/display.comp", "void main() {",
         "layout(set = 0, binding = 31) buffer More { float more[]; };\nvoid main() { more[0] = 1.0;");
    edit("raster/surface.frag", "layout(location = 0) out vec4 color;", "layout(location = 1) out vec4 color;");
    const auto compiled = ShaderTree(folder / "shaders").compile({"display/display.comp", "raster/surface.frag"});
    EXPECT_THAT(compiled.modules, IsEmpty());
    EXPECT_THAT(compiled.errors, Contains(Field(&ShaderError::message, HasSubstr("the program binds nothing there"))));
    EXPECT_THAT(compiled.errors, Contains(Field(&ShaderError::message, HasSubstr("is missing"))));
    EXPECT_THAT(misfits(find_shader("raster/surface.frag"), std::vector<std::uint32_t>{1, 2, 3}), Not(IsEmpty()));
    EXPECT_THAT(misfits(find_shader("raster/surface.frag"), find_shader("raster/surface.vert").words), Not(IsEmpty()));
    EXPECT_THAT(misfits(find_shader("raster/surface.frag"), find_shader("raster/surface.frag").words), IsEmpty());
}

TEST_F(LiveShaders, AFileReplacesAFunction) {
    const fs::path mine = write("mine.glsl", "const float gain = 0.5; // @slider(0, 2)\n"
                                             "float phong_specular(vec3 n, vec3 l, vec3 v, float shininess) {\n"
                                             "    return gain * original_phong_specular(n, l, v, 4.0 * shininess);\n}\n");
    const ShaderTree tree(folder / "shaders", {mine});
    EXPECT_THAT(tree.replaced(), AllOf(Contains("raster/surface.frag"), Not(Contains("display/display.comp"))));
    const auto compiled = tree.compile({"raster/surface.frag"});
    EXPECT_THAT(compiled.errors, IsEmpty());
    ASSERT_EQ(compiled.sliders.size(), 1u);
    EXPECT_EQ(compiled.sliders[0].name, "gain");
}

TEST_F(LiveShaders, ErrorsOfAReplacementAreInItsFile) {
    const fs::path mine = write("mine.glsl", "float lambert(vec3 n, vec3 l) {\n    return dot(n, wrong);\n}\n");
    const auto compiled = ShaderTree(folder / "shaders", {mine}).compile({"raster/surface.frag"});
    ASSERT_FALSE(compiled.errors.empty());
    EXPECT_EQ(compiled.errors[0].file, mine.string());
    EXPECT_EQ(compiled.errors[0].line, 2u);
    const fs::path other = write("other.glsl", "float nobody_calls_me() { return 1.0; }\n");
    EXPECT_THAT(ShaderTree(folder / "shaders", {other}).compile({}).errors[0].message, HasSubstr("no function of the name of one below"));
}

TEST_F(LiveShaders, CompilingHasALimit) {
    const auto compiled = ShaderTree(folder / "shaders").compile({"raytrace/shade.comp"}, std::chrono::milliseconds(1));
    ASSERT_EQ(compiled.errors.size(), 1u);
    EXPECT_THAT(compiled.errors[0].message, HasSubstr("takes too long"));
}

} // namespace
} // namespace lightbench
