// What is typed after `make`: every mistake is a problem that says what would be right.
#include "scene/make.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace lightbench;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

std::vector<std::string> complaints(std::string_view kind, const MakeArguments& arguments) {
    std::vector<std::string> texts;
    const auto result = make_scene(kind, arguments);
    if (const auto* problems = std::get_if<Problems>(&result))
        for (const Problem& p : *problems) texts.push_back(to_string(p));
    return texts;
}

} // namespace

TEST(MakeArguments, UnknownKind) {
    EXPECT_THAT(complaints("spherflake", {}), ElementsAre("make: unknown kind \"spherflake\"; did you mean \"sphereflake\"?"));
    EXPECT_THAT(complaints("zebra", {}), ElementsAre(AllOf(HasSubstr("there are sphereflake, primitives"), HasSubstr("mesh"))));
    EXPECT_THAT(complaints("", {}), ElementsAre(HasSubstr("unknown kind \"\"")));
}

TEST(MakeArguments, UnknownParameter) {
    EXPECT_THAT(complaints("sphereflake", {{"deph", "3"}}),
                ElementsAre("make sphereflake: unknown parameter \"deph\"; did you mean \"depth\"?"));
    EXPECT_THAT(complaints("sphereflake", {{"color", "3"}}), ElementsAre(HasSubstr("there are depth")));
    EXPECT_THAT(complaints("primitives", {{"n", "3"}}), ElementsAre(HasSubstr("it takes none")));
}

TEST(MakeArguments, ValuesThatAreNoneOrOutOfRange) {
    for (const char* bad : {"-1", "1e9", "nan", "inf", "-inf", "2.5", "", "three", "3 ", " 3", "3x", "0x10", "1e999", "4194304"})
        EXPECT_THAT(complaints("spheres", {{"n", bad}}),
                    ElementsAre(AllOf(HasSubstr("parameter \"n\" is"), HasSubstr("whole number from 1 to 4194303"))))
            << bad;
    EXPECT_THAT(complaints("sphereflake", {{"depth", "50"}}),
                ElementsAre(AllOf(HasSubstr("depth\" is 50"), HasSubstr("at most 4 194 304 objects"))));
    EXPECT_THAT(complaints("sphereflake", {{"depth", "7"}}), testing::SizeIs(1));
    EXPECT_THAT(complaints("mesh", {{"triangles", "1e12"}}), ElementsAre(HasSubstr("1 GiB")));
    EXPECT_THAT(complaints("corrugated", {{"slope", "90"}}), ElementsAre(HasSubstr("a number from 1 to 80")));
}

TEST(MakeArguments, GoodOnesInEveryNotation) {
    for (const char* good : {"2", "2.0", "2e0", "0.2e1"}) EXPECT_THAT(complaints("sphereflake", {{"depth", good}}), IsEmpty()) << good;
}

TEST(MakeArguments, AllProblemsTogether) {
    EXPECT_THAT(complaints("lights", {{"n", "0"}, {"m", "3"}, {"objects", "-2"}}), testing::SizeIs(3));
    EXPECT_THAT(complaints("lights", {{"n", "5"}, {"n", "6"}}), ElementsAre(HasSubstr("given twice")));
    EXPECT_THAT(complaints("lights", {{"n", "0"}, {"n", "6"}}), ElementsAre(HasSubstr("is 0"), HasSubstr("given twice")));
}
