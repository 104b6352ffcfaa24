// Functions found, replaced and given sliders in GLSL that people write.
#include "render/live/shader_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace lightbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> names(std::string_view glsl) {
    std::vector<std::string> found;
    for (const FunctionText& f : functions_of(glsl)) found.push_back(f.name);
    return found;
}

TEST(ShaderText, FindsFunctions) {
    EXPECT_THAT(names("#define F(x) { x }\n// float a() { }\nfloat b(float x) { if (x > 0.0) { return x; } return 0.0; }\n"
                      "/* vec3 c() {} */ struct S { float d; };\nconst float e[2] = {1.0, 2.0};\nvec3\nf(vec3 p,\n vec3 q)\n{ return p; }\n"
                      "precise float g() { return 1.0; }\nvoid h();\n"),
                ElementsAre("b", "f", "g"));
    EXPECT_THAT(names(""), ElementsAre());
    EXPECT_THAT(names("float broken(float x) { if (x) {"), ElementsAre());
    EXPECT_THAT(names("}}}} ;;; float a() { return 1.0; }"), ElementsAre("a"));
    EXPECT_THAT(names(fmt::format("{:x>1000000} {{}}", "")), ElementsAre());
}

TEST(ShaderText, PutsAFunctionInAnothersPlace) {
    const std::string library = "float a() { return 1.0; }\nfloat b() {\n  return a();\n}\nfloat c() { return b(); }\n";
    EXPECT_EQ(
        replace_function(library, "b", "user/mine.glsl"),
        "float a() { return 1.0; }\nfloat original_b() {\n  return a();\n}\n#include \"user/mine.glsl\"\n#line 4\n\nfloat c() { return "
        "b(); }\n");
    EXPECT_FALSE(replace_function(library, "d", "user/mine.glsl"));
}

TEST(ShaderText, MakesSliders) {
    std::vector<Slider> sliders(1);
    ShaderErrors errors;
    const std::string out = with_sliders("// text\nconst float gain = 0.5; // @slider(0, 2, 1) of the light\nfloat f() { return gain; }\n",
                                         "mine.glsl", sliders, errors);
    EXPECT_EQ(out, "// text\nlayout(constant_id = 1001) const float gain = 1.0;\nfloat f() { return gain; }\n");
    ASSERT_EQ(sliders.size(), 2u);
    EXPECT_EQ(sliders[1].name, "gain");
    EXPECT_EQ(sliders[1].most, 2);
    EXPECT_TRUE(errors.empty());
}

TEST(ShaderText, RefusesWhatCannotBeASlider) {
    for (const char* bad :
         {"const int n = 1; // @slider(0, 2, 1)", "const float x = 1.0; // @slider(2, 0, 1)", "const float x = 1.0; // @slider(0, 1)",
          "const float x = 1.0; // @slider(0, 1, 1e999)", "float f() {\nconst float x = 1.0; // @slider(0, 2, 1)\nreturn x; }"}) {
        std::vector<Slider> sliders;
        ShaderErrors errors;
        EXPECT_EQ(with_sliders(bad, "mine.glsl", sliders, errors), bad);
        EXPECT_TRUE(sliders.empty());
        ASSERT_EQ(errors.size(), 1u) << bad;
        EXPECT_THAT(to_string(errors[0]), HasSubstr("mine.glsl:"));
    }
}

TEST(ShaderText, FindsLines) {
    EXPECT_EQ(line_of("a\n  b  \nc", 2), "b");
    EXPECT_EQ(line_of("a\n", 7), "");
}

} // namespace
} // namespace lightbench
