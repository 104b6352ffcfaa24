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

TEST(ShaderText, ComparesTypesWithoutNamesAndIdleQualifiers) {
    const auto functions = functions_of("precise float a(in vec3 n, const highp float  x[ 2 ],\n inout vec3 r) { return 1.0; }\n"
                                        "float b(vec3 m, float[2] y, inout vec3 s) { return 1.0; }\nfloat c(void) { return 1.0; }\n");
    ASSERT_EQ(functions.size(), 3u);
    EXPECT_EQ(functions[0].signature, "float(vec3,float[2],inout vec3)");
    EXPECT_EQ(functions[0].signature, functions[1].signature);
    EXPECT_EQ(functions[2].signature, "float()");
    EXPECT_EQ(functions[1].head, "float b(vec3 m, float[2] y, inout vec3 s)");
}

TEST(ShaderText, FindsLines) {
    EXPECT_EQ(line_of("a\n  b  \nc", 2), "b");
    EXPECT_EQ(line_of("a\n", 7), "");
}

} // namespace
} // namespace lightbench
