// The plan as text and as JSON.
#include "plan/explain.h"
#include "plan_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::Not;

Plan two_lights() {
    Scene scene = lit_sphere(LightType::point);
    scene.lights.push_back(light_of(LightType::point));
    scene.materials.resize(5);
    for (std::uint32_t i = 1; i < 5; ++i) scene.objects.push_back({Sphere{}, i});
    for (int i = 0; i < 3; ++i) scene.materials[static_cast<std::size_t>(i)].specular = glm::vec3(0.5f);
    Facts facts = gather_facts(scene);
    facts.geometry = GeometryFacts{};
    facts.geometry->triangles = 42136;
    return decide(facts, {}, {{"camera", "the scene has none"}});
}

// The columns of the example: what, where, why.
TEST(PlanExplain, TextInColumns) {
    const std::string text = explain(two_lights());
    EXPECT_THAT(text, ::testing::StartsWith("radiance   raster, phong         42 136 triangles, 2 lights, 1280x720\n"));
    EXPECT_THAT(text, HasSubstr("\n  specular                       3 of 5 materials have ks > 0\n"));
    EXPECT_THAT(text, HasSubstr("\n  attenuation: linear            2 lights\n"));
    EXPECT_THAT(text, HasSubstr("\n  - texture                      no material has a picture\n"));
    EXPECT_THAT(text, HasSubstr("\n  - transparency                 every opacity is 1\n"));
    EXPECT_THAT(text, HasSubstr("\ninstead\n  camera                         the scene has none\n"));
    EXPECT_THAT(text, HasSubstr("\ndisplay    exposure 0, clamp\n"));
    EXPECT_THAT(text, Not(HasSubstr(" \n")));
}

TEST(PlanExplain, NoDisplayForRadiance) {
    Request request;
    request.output = Output::radiance;
    EXPECT_THAT(explain(plan_of(lit_sphere(), request)), Not(HasSubstr("display")));
}

TEST(PlanExplain, JsonHoldsTheSame) {
    const Plan plan = two_lights();
    const auto json = nlohmann::json::parse(explain_json(plan));
    EXPECT_EQ(json["method"], "raster");
    EXPECT_EQ(json["shading"], "phong");
    EXPECT_EQ(json["mask"], plan.effects);
    EXPECT_EQ(json["triangles"], 42136);
    EXPECT_EQ(json["effects"].size(), plan.wanted.size());
    EXPECT_EQ(json["skipped"].size(), plan.skipped.size());
    EXPECT_EQ(json["passes"][0]["name"], "raster");
    EXPECT_THAT(json["passes"][0]["reads"].get<std::vector<std::string>>(), ::testing::Contains("lights"));
    EXPECT_EQ(json["fallbacks"][0]["name"], "camera");
    for (const auto& line : json["skipped"]) EXPECT_FALSE(line["reason"].get<std::string>().empty());
    for (const auto& resource : json["resources"]) EXPECT_EQ(resource["bytes"], bytes_of(plan, resource["name"].get<std::string>()));
}

// Names of files may hold any bytes.
TEST(PlanExplain, JsonSurvivesBrokenText) {
    const Plan plan = decide({}, {}, {{"file", "\xff\xfe \"quoted\" \n"}});
    EXPECT_TRUE(nlohmann::json::accept(explain_json(plan)));
}

} // namespace
} // namespace lightbench
