// Users' functions put in the library's place, circles of includes, and what the compiler says brought home: texts alone.
#include "render/live/compiler_errors.h"
#include "render/live/replace.h"
#include "render/live/shader_includes.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char* const kLibrary = "// text\nfloat shine(vec3 n, float e) { return e; }\nfloat glow(float e) { return e; }\n";

// "user/0/a.glsl" and so on, known as a.glsl to whoever wrote it.
Replaced replaced(const std::vector<std::pair<std::string, std::string>>& files) {
    Sources sources{{{"lib/shine.glsl", kLibrary}}, {}, {}};
    std::map<std::string, std::filesystem::path> replacements;
    for (const auto& [file, text] : files) {
        const std::string name = fmt::format("user/{}/{}", replacements.size(), file);
        sources.texts[name] = text, sources.user_files[name] = file, replacements[name] = file;
    }
    return replace_functions(sources, replacements, "shaders");
}

TEST(Replace, OneFileForEachFunction) {
    const std::string shine = "float shine(vec3 n, float e) { return 0.0; }\n";
    const auto two = replaced({{"a.glsl", shine}, {"b.glsl", "\n" + shine}});
    ASSERT_EQ(two.errors.size(), 1u);
    EXPECT_EQ(two.errors[0].message, "shine is defined in both a.glsl and b.glsl; one file must define it");
    EXPECT_EQ(two.errors[0].file, "b.glsl");
    EXPECT_EQ(two.errors[0].line, 2u);
    EXPECT_EQ(replaced({{"a.glsl", shine}, {"a.glsl", shine}}).errors.size(), 1u) << "one file twice";
    const auto apart = replaced({{"a.glsl", shine}, {"b.glsl", "float glow(float x) { return 1.0; }"}});
    EXPECT_TRUE(apart.errors.empty());
    EXPECT_THAT(apart.texts.at("lib/shine.glsl"), HasSubstr("original_glow"));
}

TEST(Replace, TypesAreThoseOfTheLibrary) {
    const auto wrong = replaced({{"a.glsl", "\n\nfloat shine(vec3 n) { return 0.0; }\n"}});
    ASSERT_EQ(wrong.errors.size(), 1u);
    EXPECT_EQ(to_string(wrong.errors[0]), "a.glsl:3: shine must be float shine(vec3 n, float e), as in shaders/lib/shine.glsl:2\n"
                                          "    float shine(vec3 n) { return 0.0; }");
    EXPECT_EQ(replaced({{"a.glsl", "vec3 shine(vec3 n, float e) { return n; }\n"}}).errors.size(), 1u) << "another result";
    EXPECT_TRUE(replaced({{"a.glsl", "float shine(const in vec3 m, float f) { return 0.0; }\nfloat shine(vec3 n) { return 1.0; }\n"}})
                    .errors.empty())
        << "an overload besides";
}

TEST(Replace, SaysWhatThereIsToReplace) {
    EXPECT_EQ(replaced({{"a.glsl", "float shines(vec3 n, float e) { return 0.0; }"}}).errors.at(0).message,
              "defines shines, but no function of the name of one below shaders/lib/; did you mean \"shine\"?");
    EXPECT_THAT(replaced({{"a.glsl", "float nobody_calls_this() { return 0.0; }"}}).errors.at(0).message,
                HasSubstr("shaders/lib/: glow, shine"));
    EXPECT_THAT(replaced({{"a.glsl", " \r\n"}}).errors.at(0).message, HasSubstr("is empty"));
}

TEST(Includes, AreFoundWithTheirLines) {
    const auto includes = includes_of("// #include \"no\"\n  #  include \"a/b.glsl\" // x\n#include <c>\n#include \"d\"\r\n#include \"e\n");
    ASSERT_EQ(includes.size(), 2u);
    EXPECT_EQ(includes[0].name, "a/b.glsl");
    EXPECT_EQ(includes[0].line, 2u);
    EXPECT_EQ(includes[1].name, "d");
}

TEST(Includes, InCirclesAreFoundUnlessAGuardEndsThem) {
    const std::string a = "#include \"lib/b.glsl\"\n", b = "\n#include \"a.glsl\"\n";
    const auto found = circles({{"lib/a.glsl", a}, {"lib/b.glsl", b}, {"x.comp", "#version 460\n#include \"lib/a.glsl\"\n"}});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].file, "lib/b.glsl");
    EXPECT_EQ(found[0].line, 2u);
    EXPECT_THAT(found[0].message, HasSubstr("lib/b.glsl"));
    EXPECT_EQ(circles({{"lib/c.glsl", "#include \"lib/c.glsl\"\n"}}).at(0).message, "includes itself");
    EXPECT_TRUE(circles({{"lib/a.glsl", "#ifndef A\n#define A\n" + a + "#endif\n"}, {"lib/b.glsl", b}}).empty());
}

// What glslang 12 writes.
class CompilerErrors : public testing::Test {
  protected:
    bool read(const std::string& said, const std::string& entry_point) {
        return read_errors(said, entry_point, {root, user_files, texts, "/stage"}, errors);
    }
    const std::filesystem::path root = "shaders";
    const std::map<std::string, std::filesystem::path> user_files = {{"user/0/mine.glsl", "mine.glsl"}};
    const std::map<std::string, std::string> texts = {{"lib/a.glsl", "float a() { return x; }\n"},
                                                      {"user/0/mine.glsl", "\nfloat loop(float x) { return loop(x); }\n"}};
    ShaderErrors errors;
};

TEST_F(CompilerErrors, WithoutAPlaceAreLeftOutBesideThoseThatHaveOne) {
    const std::string located = "ERROR: /stage/lib/a.glsl:1: 'x' : undeclared identifier \n",
                      noise =
                          "ERROR: 1 compilation errors.  No code generated.\n\n\nERROR: Linking compute stage: Missing entry point: Each "
                          "stage requires one entry point\n\nSPIR-V is not generated for failed compile or link\n";
    EXPECT_TRUE(read(located + noise, "one.comp"));
    EXPECT_TRUE(read(located + noise, "two.comp")) << "all of it was said before";
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(to_string(errors[0]), "shaders/lib/a.glsl:1: 'x' : undeclared identifier\n    float a() { return x; }");
    errors.clear();
    EXPECT_TRUE(read(noise, "one.comp"));
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].file, "shaders/one.comp");
    EXPECT_FALSE(read("nothing\n", "one.comp"));
}

TEST_F(CompilerErrors, OfRecursionNameTheFunctionAndWhereItIs) {
    const std::string said =
        "ERROR: Linking fragment stage: Recursion detected:\n    loop(f1; calling loop(f1;\n\nSPIR-V is not generated\n";
    EXPECT_TRUE(read(said, "one.comp") && read(said, "two.comp"));
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(to_string(errors[0]), "mine.glsl:2: loop calls itself: GLSL has no recursion\n    float loop(float x) { return loop(x); }");
}

} // namespace
} // namespace lightbench
