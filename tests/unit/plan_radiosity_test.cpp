// When a scene calls for radiosity: something must send light, and something diffuse must send it on; what is left out says why.
#include "plan_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using namespace testing;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Request radiosity() {
    Request request;
    request.method = Method::radiosity;
    return request;
}

Scene glowing() {
    Scene scene = bare_sphere();
    scene.materials[0].emission = glm::vec3(1);
    return scene;
}

TEST(PlanRadiosity, GlowingSurfacesAreShot) {
    const Plan plan = plan_of(glowing(), radiosity());
    EXPECT_EQ(plan.method, Method::radiosity);
    EXPECT_THAT(pass_names(plan), ElementsAre("hemi-cube", "shots", "raster", "display"));
    EXPECT_TRUE(plan.has("elements") && plan.has("structure") && plan.has("form-factors") && plan.has("radiosity"));
    EXPECT_FALSE(plan.has("vertices") || plan.has("lights") || plan.has("materials"));
}

TEST(PlanRadiosity, WithoutAnySourceThereIsNone) {
    const Plan plan = plan_of(bare_sphere(), radiosity());
    EXPECT_EQ(plan.method, Method::raster);
    EXPECT_EQ(reason_of(plan.fallbacks, "radiosity"), "no material glows and there is no light: drawn by the rasteriser");
    EXPECT_THAT(pass_names(plan), Not(Contains("hemi-cube")));
}

TEST(PlanRadiosity, AHeadlightIsNoSource) {
    Scene scene = lit_sphere();
    Facts facts = gather_facts(scene);
    facts.headlight = true;
    EXPECT_EQ(decide(facts, radiosity()).method, Method::raster);
    facts.headlight = false;
    EXPECT_EQ(decide(facts, radiosity()).method, Method::radiosity);
}

TEST(PlanRadiosity, SpecularSurfacesAloneHaveNone) {
    Scene scene = glowing();
    scene.materials[0].diffuse = glm::vec3(0), scene.materials[0].specular = glm::vec3(1);
    const Plan plan = plan_of(scene, radiosity());
    EXPECT_EQ(plan.method, Method::raster);
    EXPECT_THAT(reason_of(plan.fallbacks, "radiosity"), HasSubstr("no material has kd > 0"));
}

TEST(PlanRadiosity, LightsFeedWhereNothingGlows) {
    const Plan plan = plan_of(lit_sphere(), radiosity());
    EXPECT_THAT(pass_names(plan), ElementsAre("feed", "hemi-cube", "shots", "raster", "display"));
    EXPECT_TRUE(plan.has("lights"));
}

TEST(PlanRadiosity, LightsBesideLampsFeedOnlyIfAsked) {
    Scene scene = glowing();
    scene.lights.push_back(light_of(LightType::point));
    Request request = radiosity();
    EXPECT_FALSE(plan_of(scene, request).runs("feed"));
    EXPECT_THAT(reason_of(plan_of(scene, request).skipped, "point light"), HasSubstr("--feed-lights"));
    request.radiosity.feed = true;
    EXPECT_TRUE(plan_of(scene, request).runs("feed"));
}

TEST(PlanRadiosity, WhatItDoesNotKnowIsSaid) {
    Scene scene = glowing();
    scene.materials[0].specular = glm::vec3(0.5f), scene.materials[0].opacity = glm::vec3(0.5f);
    const Plan plan = plan_of(scene, radiosity());
    EXPECT_EQ(reason_of(plan.skipped, "transparency"), "radiosity: surfaces are opaque and diffuse");
    EXPECT_EQ(plan.effects & ~plan_of(glowing(), radiosity()).effects, 0u);
}

TEST(PlanRadiosity, TheFullMatrixHasNoShots) {
    Request request = radiosity();
    request.radiosity.solver = Solver::full, request.radiosity.shots = 5;
    const Plan plan = plan_of(glowing(), request);
    EXPECT_THAT(pass_names(plan), ElementsAre("hemi-cube", "gauss-seidel", "raster", "display"));
    EXPECT_THAT(reason_of(plan.fallbacks, "shots"), HasSubstr("--shots is left out"));
}

TEST(PlanRadiosity, WhiteIsNotQuiteWhite) {
    Scene scene = glowing();
    scene.materials[0].diffuse = glm::vec3(1);
    EXPECT_THAT(reason_of(plan_of(scene, radiosity()).fallbacks, "reflectance"), HasSubstr("1 material with kd above 0.999"));
}

} // namespace
} // namespace lightbench
