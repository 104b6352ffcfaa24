// Constants that become sliders, and what cannot.
#include "render/live/sliders.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using ::testing::HasSubstr;

TEST(Sliders, AreMadeOfMarkedConstants) {
    std::vector<Slider> sliders(1);
    ShaderErrors errors;
    const std::string out = with_sliders("// text\nconst float gain = 1.0; // @slider(0, 2) of the light\nfloat f() { return gain; }\n",
                                         "mine.glsl", sliders, errors);
    EXPECT_EQ(out, "// text\nlayout(constant_id = 1001) const float gain = 1.0;\nfloat f() { return gain; }\n");
    ASSERT_EQ(sliders.size(), 2u);
    EXPECT_EQ(sliders[1].name, "gain");
    EXPECT_EQ(sliders[1].most, 2);
    EXPECT_EQ(sliders[1].value, 1);
    EXPECT_TRUE(errors.empty());
}

TEST(Sliders, BeginWithTheConstantsOwnValueHoweverItIsWritten) {
    for (const char* line : {"const float x = .5; // @slider(0, 1)", "const float x = 0.5f;//@slider(-1,1,0.5)",
                             "const float x = +5e-1; // @slider( 0.0 , 1.0 , .5 )", "const float x = 0.5; // @slider(0, 1)\r\n"}) {
        std::vector<Slider> sliders;
        ShaderErrors errors;
        with_sliders(line, "mine.glsl", sliders, errors);
        ASSERT_EQ(sliders.size(), 1u) << line << (errors.empty() ? "" : to_string(errors[0]));
        EXPECT_EQ(sliders[0].value, 0.5f);
    }
}

TEST(Sliders, ThatContradictTheConstantAreErrors) {
    std::vector<Slider> sliders;
    ShaderErrors errors;
    with_sliders("const float sharpness = 16.0; // @slider(1, 16, 4)", "mine.glsl", sliders, errors);
    with_sliders("const float sharpness = 32.0; // @slider(1, 16)", "mine.glsl", sliders, errors);
    EXPECT_TRUE(sliders.empty());
    ASSERT_EQ(errors.size(), 2u);
    EXPECT_EQ(errors[0].message, "sharpness is 16, but its slider begins with 4; @slider(1, 16) begins with the constant's own value");
    EXPECT_EQ(errors[1].message, "sharpness is 32; its slider goes from 1 to 16");
}

TEST(Sliders, AreRefusedWhereTheyCannotBe) {
    for (const char* bad :
         {"const int n = 1; // @slider(0, 2)", "const float x = 1.0; // @slider(2, 0)", "const float x = 1.0; // @slider(0)",
          "const float x = 1.0; // @slider(0, 1e999)", "const float x = 2.0 * y; // @slider(0, 1)",
          "float f() {\nconst float x = 1.0; // @slider(0, 2)\nreturn x; }"}) {
        std::vector<Slider> sliders;
        ShaderErrors errors;
        EXPECT_EQ(with_sliders(bad, "mine.glsl", sliders, errors), bad);
        EXPECT_TRUE(sliders.empty());
        ASSERT_EQ(errors.size(), 1u) << bad;
        EXPECT_THAT(to_string(errors[0]), HasSubstr("mine.glsl:"));
    }
}

} // namespace
} // namespace lightbench
