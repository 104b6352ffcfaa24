// The table of knobs: what is typed, what it changes, what is refused.
#include "measure/knobs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using ::testing::HasSubstr;

std::string problem_of(std::string_view text) {
    std::string problem;
    EXPECT_FALSE(parse_knob(text, problem)) << text;
    return problem;
}

OptionTexts applied(std::string_view knob, std::string_view value, OptionTexts options = {}) {
    return with_value(*find_knob(knob), value, std::move(options));
}

Scene unit_scene() {
    Scene scene;
    scene.materials = {Material{}};
    scene.objects = {Object{.shape = Box{}}};
    return scene;
}

TEST(Knobs, ValuesBecomeOptions) {
    EXPECT_EQ(applied("spp", "jittered/16", {{"--sampling", "uniform"}}), (OptionTexts{{"--sampling", "jittered"}, {"--spp", "16"}}));
    EXPECT_EQ(applied("spp", "4", {{"--sampling", "adaptive"}, {"--max-level", "2"}}), (OptionTexts{{"--spp", "4"}}));
    EXPECT_EQ(applied("shading", "gouraud/2"), (OptionTexts{{"--method", "raster"}, {"--shading", "gouraud"}, {"--subdivide", "2"}}));
    EXPECT_EQ(applied("shading", "flat", {{"--subdivide", "2"}}), (OptionTexts{{"--method", "raster"}, {"--shading", "flat"}}));
    EXPECT_EQ(applied("contrast", "0.5/3", {{"--spp", "4"}}),
              (OptionTexts{{"--method", "raytrace"}, {"--sampling", "adaptive"}, {"--contrast", "0.5,0.4,0.8"}, {"--max-level", "3"}}));
    EXPECT_EQ(applied("leaf", "octree/8"), (OptionTexts{{"--method", "raytrace"}, {"--accel", "octree"}, {"--accel-param", "leaf=8"}}));
    EXPECT_EQ(applied("shots", "16/no-ambient"),
              (OptionTexts{{"--method", "radiosity"}, {"--shots", "16"}, {"--no-ambient", ""}, {"--until", "0.0001"}}));
    EXPECT_EQ(applied("solver", "progressive/0.01", {{"--patch", "2"}}).at("--element"), "2");
}

// Whatever a value sets, another value of the knob sets or takes back: turning it to and fro leaves nothing behind.
TEST(Knobs, ValuesLeaveNothingBehind) {
    for (const Knob& knob : knobs()) {
        OptionTexts base;
        if (knob.base) knob.base(base, unit_scene());
        const auto values = default_values(knob, unit_scene());
        ASSERT_FALSE(values.empty()) << knob.name;
        for (const std::string& value : values)
            for (const std::string& other : values)
                EXPECT_EQ(with_value(knob, value, with_value(knob, other, base)), with_value(knob, value, base))
                    << knob.name << " " << value;
    }
}

TEST(Knobs, EachHasAReferenceOfItsMethodAndASecondOne) {
    for (const Knob& knob : knobs()) {
        const auto values = default_values(knob, unit_scene());
        OptionTexts first{{"--method", std::string(knob.method)}}, second = first;
        if (knob.base) knob.base(first, unit_scene());
        second = first;
        knob.refer(first, values, false), knob.refer(second, values, true);
        const bool exact = knob.time_only || knob.name == "model" || knob.name == "attenuation" || knob.name == "precision";
        EXPECT_EQ(first == second, exact) << knob.name;
        EXPECT_FALSE(knob.meaning.empty() || knob.reference.empty() || knob.values.empty()) << knob.name;
        std::string problem;
        EXPECT_TRUE(parse_knob(fmt::format("{}={}", knob.name, fmt::join(values, ",")), problem)) << problem;
    }
}

TEST(Knobs, MistakesAreNamed) {
    EXPECT_EQ(problem_of("shadnig"), "there is no knob \"shadnig\"; did you mean \"shading\"?");
    EXPECT_THAT(problem_of("xyzzy=1"), HasSubstr("it must be one of shading, model, attenuation, precision, spp"));
    EXPECT_EQ(problem_of("shading=flat,blinn"),
              "\"blinn\" is no value of shading; it must be flat, gouraud or phong, and /N for --subdivide N");
    EXPECT_THAT(problem_of("spp="), HasSubstr("a value of spp is empty"));
    EXPECT_THAT(problem_of("spp=4,,16"), HasSubstr("a value of spp is empty"));
    EXPECT_THAT(problem_of("spp=uniform/"), HasSubstr("is no value of spp"));
    EXPECT_THAT(problem_of("spp=-4"), HasSubstr("is no value of spp"));
    EXPECT_THAT(problem_of("spp=4,4"), HasSubstr("\"4\" is there twice"));
    EXPECT_THAT(problem_of("cutoff=nan"), HasSubstr("is no value of cutoff"));
    EXPECT_THAT(problem_of("contrast=2"), HasSubstr("is no value of contrast"));
}

TEST(Knobs, EqualValuesAreOne) {
    EXPECT_EQ(problem_of("patch=2e+2,200"), "patch: \"2e+2\" and \"200\" are the same; once is enough");
    EXPECT_EQ(problem_of("depth=2,02"), "depth: \"2\" and \"02\" are the same; once is enough");
    EXPECT_THAT(problem_of("grid-density=8,8.0"), HasSubstr("are the same"));
    std::string problem;
    EXPECT_TRUE(parse_knob("patch=2e+1,2e-1", problem)) << problem;
}

TEST(Knobs, FunctionsHaveNoValues) {
    EXPECT_EQ(problem_of("functions=foo"), "functions has no values; the name alone is right");
    EXPECT_THAT(problem_of("function"), HasSubstr("did you mean \"functions\"?"));
}

OptionTexts reference(std::string_view knob, const std::vector<std::string>& values, OptionTexts options = {}, bool again = false) {
    find_knob(knob)->refer(options, values, again);
    return options;
}

// A reference is finer than the finest value, and than what was typed; where none can be, the value is refused.
TEST(Knobs, ReferencesGrowWithTheValues) {
    EXPECT_EQ(reference("hemicube", {"16", "256"}).at("--hemicube"), "512");
    EXPECT_EQ(reference("hemicube", {"16", "256"}, {}, true).at("--hemicube"), "400");
    EXPECT_EQ(reference("hemicube", {"512", "16"}).at("--hemicube"), "1024");
    EXPECT_EQ(reference("hemicube", {"512", "16"}, {}, true).at("--hemicube"), "800");
    EXPECT_THAT(problem_of("hemicube=1024"), HasSubstr("an even number from 8 to 512"));
    EXPECT_EQ(reference("form-factors", {"corrected/512"}).at("--hemicube"), "1024");
    EXPECT_EQ(reference("form-factors", {"corrected"}, {{"--hemicube", "400"}}).at("--hemicube"), "800");
    EXPECT_THAT(problem_of("form-factors=corrected/1024"), HasSubstr("N at most 512"));
    EXPECT_EQ(reference("patch", {"1"}, {{"--hemicube", "512"}}).at("--hemicube"), "512");
    EXPECT_EQ(reference("solver", {"progressive/0.00001"}).at("--until"), "1e-06");
    EXPECT_EQ(reference("depth", {"32", "100"}, {{"--cutoff", "1e-5"}}), (OptionTexts{{"--cutoff", "1e-05"}, {"--depth", "200"}}));
    EXPECT_EQ(reference("depth", {"1", "10"}, {{"--cutoff", "0.1"}}), (OptionTexts{{"--cutoff", "0.0005"}, {"--depth", "64"}}));
    EXPECT_THAT(problem_of("depth=200"), HasSubstr("from 1 to 127"));
    EXPECT_EQ(reference("cutoff", {"0.0004"}, {{"--depth", "100"}}), (OptionTexts{{"--cutoff", "0.0001"}, {"--depth", "100"}}));
    EXPECT_EQ(reference("spp", {"jittered/64"}, {{"--method", "raytrace"}}).at("--spp"), "400");
    EXPECT_EQ(reference("spp", {"jittered/1024", "4"}, {{"--method", "raytrace"}}).at("--spp"), "1024");
    EXPECT_EQ(reference("contrast", {"0.5/4"}, {{"--method", "raytrace"}}).at("--spp"), "1024");
    EXPECT_EQ(reference("filter", {"box"}, {{"--method", "raytrace"}, {"--spp", "225"}}).at("--spp"), "900");
    EXPECT_EQ(reference("spp", {"4"}, {{"--seed", "10001"}}).at("--seed"), "20002");
    EXPECT_EQ(reference("spp", {"4"}, {{"--seed", "10001"}}, true).at("--seed"), "30003");
    EXPECT_EQ(reference("spp", {"4"}, {{"--seed", "20002"}}, true).at("--seed"), "30003");
}

// Without a number the hemi-cube is that of --hemicube.
TEST(Knobs, FormFactorsKnowTheirHemicube) {
    const Knob& knob = *find_knob("form-factors");
    EXPECT_EQ(knob.scale("corrected", {{"--hemicube", "128"}})->x, 128);
    EXPECT_EQ(knob.scale("corrected", {})->x, 64);
    EXPECT_EQ(knob.scale("hemicube/32", {{"--hemicube", "128"}})->x, 32);
}

TEST(Knobs, WithoutValuesTheKnobsOwnAreTaken) {
    std::string problem;
    const auto use = parse_knob("spp", problem);
    ASSERT_TRUE(use);
    EXPECT_TRUE(use->values.empty());
    EXPECT_EQ(default_values(*use->knob, unit_scene()).size(), 12u);
    const auto lengths = default_values(*find_knob("patch"), unit_scene()); // a unit cube: its sphere's radius is 0.866
    EXPECT_EQ(lengths.front(), "0.866");
    EXPECT_EQ(lengths.size(), 5u);
}

TEST(Knobs, CommandsAreForAShell) {
    EXPECT_EQ(command_of({{"SCENE", "my scene.toml"}, {"--spp", "16"}, {"--no-ambient", ""}, {"--device", "it's"}}, "x.png"),
              "'my scene.toml' -o x.png --device 'it'\\''s' --no-ambient --spp 16");
}

} // namespace
} // namespace lightbench
