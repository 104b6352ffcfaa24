// Which objects have a cube of what is around them, how large it is, who shares it, and what the plan says of it.
#include "plan/complete.h"
#include "plan/explain.h"
#include "unit/plan_scenes.h"

#include <gtest/gtest.h>

#include <array>

namespace lightbench::testing {
namespace {

// Mirroring balls of radius 1 along -z, 10 m apart, the last first; the camera is at the origin, its image is 1000 pixels high.
Scene row_of(std::size_t balls) {
    Scene scene = lit_sphere();
    scene.objects.clear();
    scene.materials[0].environment = 1;
    for (std::size_t i = 0; i < balls; ++i) scene.objects.push_back({Sphere{{0, 0, -10.0 * double(balls - i)}, 1}});
    Camera camera;
    camera.position = {0, 0, 0}, camera.target = {0, 0, -1};
    scene.cameras = {camera};
    return scene;
}

EnvironmentCubes cubes_of(Scene scene) {
    Request request;
    request.size = glm::uvec2(1000);
    return choose_cubes(scene, complete(scene, request).completed.value().view);
}

TEST(PlanCubes, TheNearestFirstFromTheirMiddles) {
    const EnvironmentCubes cubes = cubes_of(row_of(3));
    ASSERT_EQ(cubes.cubes.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(cubes.cubes[i].object, 2 - i);
        EXPECT_EQ(cubes.cubes[i].center, glm::dvec3(0, 0, -10.0 * (i + 1)));
        EXPECT_EQ(cubes.of_object[i], 2 - i);
    }
}

// A ball of radius 1 at distance d spans 2 asin(1 / d) of 2 atan(tan(22.5 deg) / 1000) a pixel: 242, 121, 81 and 60 pixels.
TEST(PlanCubes, AsLargeAsTheObjectIsSeen) {
    const EnvironmentCubes cubes = cubes_of(row_of(4));
    const std::array<unsigned, 4> sizes = {256, 128, 128, 64};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(cubes.cubes[i].size, sizes[i]) << i;
    Scene inside = row_of(1);
    std::get<Sphere>(inside.objects[0].shape).radius = 11;
    EXPECT_EQ(cubes_of(inside).cubes[0].size, kLargestCubeSize);
    std::get<Sphere>(inside.objects[0].shape).radius = 1e-3;
    EXPECT_EQ(cubes_of(inside).cubes[0].size, kLeastCubeSize);
}

TEST(PlanCubes, NoMoreThanEight) {
    const EnvironmentCubes cubes = cubes_of(row_of(11));
    EXPECT_EQ(cubes.objects, 11u);
    ASSERT_EQ(cubes.cubes.size(), kMostCubes);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(cubes.of_object[i], 7u) << "the farthest share the eighth's";
}

// Eight that fill the image: 8 faces of 512 pixels do not fit, of 256 they do.
TEST(PlanCubes, ManyLargeOnesAreHalved) {
    Scene scene = row_of(8);
    for (Object& object : scene.objects) object.shape = Sphere{{0, 0, -3}, 1};
    for (const EnvironmentCube& cube : cubes_of(scene).cubes) EXPECT_EQ(cube.size, 256u);
    scene.objects.resize(4);
    for (const EnvironmentCube& cube : cubes_of(scene).cubes) EXPECT_EQ(cube.size, 512u);
}

TEST(PlanCubes, OnlyWhatMirrorsCounts) {
    Scene scene = row_of(2);
    scene.materials.resize(2);
    scene.objects[1].material = 1;
    scene.meshes.emplace_back().face_materials = {1};
    scene.objects.push_back({MeshUse{0}});
    const EnvironmentCubes cubes = cubes_of(scene);
    ASSERT_EQ(cubes.cubes.size(), 1u);
    EXPECT_EQ(cubes.cubes[0].object, 0u);
    scene.materials[0].environment = 0;
    EXPECT_TRUE(cubes_of(scene).cubes.empty());
    EXPECT_TRUE(cubes_of(scene).of_object.empty());
}

TEST(PlanCubes, WhatHasNoExtentMirrorsNothing) {
    Scene scene = row_of(1);
    scene.meshes.emplace_back().face_starts = {0};
    scene.objects[0].shape = MeshUse{0};
    Facts facts = gather_facts(scene);
    add_view(facts, scene, {});
    EXPECT_EQ(reason_of(decide(facts, {}).skipped, "environment: rendered"), "nothing that mirrors it has an extent");
    EXPECT_NE(reason_of(decide(facts, {}).skipped, "environment: mirrored"), "(none)");
}

TEST(PlanCubes, ThePlanSaysHowManyHowLargeAndWhoShares) {
    Scene scene = row_of(9);
    Request request;
    request.size = glm::uvec2(1000);
    const View view = complete(scene, request).completed.value().view;
    Facts facts = gather_facts(scene);
    add_view(facts, scene, view);
    const Plan plan = decide(facts, request);
    EXPECT_EQ(reason_of(plan.wanted, "environment: rendered"), "the scene has no map: 9 objects mirror it");
    EXPECT_EQ(reason_of(plan.fallbacks, "environment: rendered"),
              "9 objects mirror: the 8 nearest to the camera have cubes of their own, the others share the nearest of those");
    const std::string text = explain(plan);
    EXPECT_NE(text.find("6 views from the middle of what mirrors, without it, 256, 128, 128, 64, 64, 64, 64, 32 pixels a side"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("one bounce"), std::string::npos);
    request.method = Method::raytrace;
    EXPECT_TRUE(decide(facts, request).cubes.cubes.empty());
}

} // namespace
} // namespace lightbench::testing
