// What a scene leaves out is filled in and said; what is impossible is refused with a reason.
#include "plan/complete.h"
#include "plan_scenes.h"
#include "scene/limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using namespace testing;
using ::testing::HasSubstr;

// The sole problem's text; fails if there is another number of them.
std::string only_problem(const CompleteResult& result) {
    EXPECT_EQ(result.problems.size(), 1u);
    EXPECT_FALSE(result.completed);
    return result.problems.empty() ? "" : to_string(result.problems[0]);
}

Scene with_camera(const char* name = "front") {
    Scene scene = lit_sphere();
    scene.cameras.emplace_back().name = name;
    return scene;
}

Request sized(unsigned width, unsigned height) {
    Request request;
    request.size = glm::uvec2(width, height);
    return request;
}

// The sphere's outline touches the narrower pair of the image's edges, and does not cross the others.
TEST(PlanComplete, TheFittedCameraSeesAllOfTheScene) {
    for (glm::uvec2 size : {glm::uvec2(1280, 720), glm::uvec2(100, 1000), glm::uvec2(64, 64)}) {
        Scene scene = lit_sphere();
        scene.objects = {{Box{{10, -3, 5}, {14, 2, 6}}}};
        const auto completed = complete(scene, sized(size.x, size.y)).completed;
        ASSERT_TRUE(completed);
        EXPECT_THAT(reason_of(completed->notes, "camera"), HasSubstr("none"));
        const glm::dvec3 center(12, -0.5, 5.5);
        const double radius = glm::length(glm::dvec3(4, 5, 1)) / 2, distance = glm::length(completed->view.eye - center);
        const double half_vertical = completed->view.fov / 2, half_horizontal = std::atan(std::tan(half_vertical) * size.x / size.y);
        EXPECT_NEAR(std::asin(radius / distance), std::min(half_vertical, half_horizontal), 1e-12);
        const glm::dvec3 from = completed->view.eye - center;
        EXPECT_TRUE(from.z > from.y && from.y > from.x && from.x > 0); // front, above, slightly to the right
        EXPECT_DOUBLE_EQ(completed->view.fov, 3.14159265358979323846 / 4);
    }
}

TEST(PlanComplete, TheHeadlightShinesAlongTheView) {
    Scene scene = with_camera();
    scene.lights.clear();
    const auto completed = complete(scene, {}).completed;
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].type, LightType::directional);
    EXPECT_NEAR(scene.lights[0].direction.z, -1, 1e-15); // the camera looks from +z to the origin
    EXPECT_EQ(scene.lights[0].intensity, glm::vec3(1));
    EXPECT_THAT(reason_of(completed->notes, "light"), HasSubstr("headlight"));
}

TEST(PlanComplete, DarkLightsAreLights) {
    Scene scene = with_camera();
    scene.lights[0].intensity = glm::vec3(0);
    EXPECT_EQ(reason_of(complete(scene, {}).completed->notes, "light"), "(none)");
    EXPECT_EQ(scene.lights.size(), 1u);
}

TEST(PlanComplete, SizeIsAskedForElseTheFilmsElseTheDefault) {
    Scene scene = with_camera();
    EXPECT_EQ(complete(scene, {}).completed->view.size, glm::uvec2(1280, 720));
    scene.film = glm::uvec2(320, 200);
    EXPECT_EQ(complete(scene, {}).completed->view.size, glm::uvec2(320, 200));
    EXPECT_EQ(complete(scene, sized(7, 9)).completed->view.size, glm::uvec2(7, 9));
}

TEST(PlanComplete, AnUnknownCameraNamesTheKnownOnes) {
    Scene scene = with_camera("left");
    scene.cameras.emplace_back().name = "right";
    scene.cameras.back().position = {5, 0, 0};
    Request request;
    request.camera = "right";
    EXPECT_EQ(complete(scene, request).completed->view.eye, glm::dvec3(5, 0, 0));
    request.camera = "rihgt";
    EXPECT_EQ(only_problem(complete(scene, request)), "--camera: no camera is named \"rihgt\"; the scene has \"left\", \"right\"");
}

TEST(PlanComplete, ImpossibleCamerasAreRefused) {
    const auto refuse = [](auto spoil) {
        Scene scene = with_camera();
        spoil(scene.cameras[0]);
        return only_problem(complete(scene, {}));
    };
    EXPECT_THAT(refuse([](Camera& c) { c.target = c.position; }),
                HasSubstr("bare: camera \"front\": position and target are the same point"));
    EXPECT_THAT(refuse([](Camera& c) { c.up = glm::dvec3(0); }), HasSubstr("up is 0"));
    EXPECT_THAT(refuse([](Camera& c) { c.fov = 0; }), HasSubstr("fov is 0 degrees"));
    EXPECT_THAT(refuse([](Camera& c) { c.fov = 3.15; }), HasSubstr("between 0 and 180"));
    EXPECT_THAT(refuse([](Camera& c) { c.position.x = std::nan(""); }), HasSubstr("finite"));
    EXPECT_THAT(refuse([](Camera& c) { c.hither = -1; }), HasSubstr("hither"));
}

TEST(PlanComplete, ImagesBeyondTheLimitAreRefused) {
    Scene scene = with_camera();
    EXPECT_THAT(only_problem(complete(scene, sized(0, 10))), HasSubstr("0x10"));
    EXPECT_THAT(only_problem(complete(scene, sized(limits::kMaxImageSide + 1, 1))), HasSubstr("1 to 16384 pixels"));
    EXPECT_TRUE(complete(scene, sized(limits::kMaxImageSide, 1)).completed);
}

TEST(PlanComplete, CropsMustLieInside) {
    Scene scene = with_camera();
    const auto cropped = [&](glm::uvec2 offset, glm::uvec2 size) {
        Request request = sized(100, 50);
        request.crop = Rect{offset, size};
        return complete(scene, request);
    };
    EXPECT_TRUE(cropped({0, 0}, {100, 50}).completed);
    EXPECT_TRUE(cropped({99, 49}, {1, 1}).completed);
    EXPECT_THAT(only_problem(cropped({99, 49}, {2, 1})), HasSubstr("2x1 at 99,49 is not inside of the 100x50 image"));
    EXPECT_THAT(only_problem(cropped({0, 0}, {0, 1})), HasSubstr("not inside"));
    EXPECT_THAT(only_problem(cropped({4294967295u, 0}, {2, 1})), HasSubstr("not inside")); // the sum would wrap around
}

TEST(PlanComplete, TheTurntableTurnsAboutTheTarget) {
    Scene scene = with_camera();
    scene.cameras[0].target = {1, 0, 0};
    scene.cameras[0].position = {1, 2, 5};
    const auto eye = [&](int frame) {
        Request request;
        request.frame = frame;
        return complete(scene, request).completed->view.eye;
    };
    EXPECT_EQ(eye(0), glm::dvec3(1, 2, 5));
    EXPECT_EQ(eye(120), eye(0)); // exactly: frame numbers are reduced, angles are not added up
    EXPECT_EQ(eye(-7), eye(113));
    const glm::dvec3 quarter = eye(30); // 90 degrees, counter-clockwise seen from above: from +z to +x
    EXPECT_NEAR(quarter.x, 6, 1e-14);
    EXPECT_NEAR(quarter.y, 2, 1e-14);
    EXPECT_NEAR(quarter.z, 0, 1e-14);
}

TEST(PlanComplete, HitherIsTheNearPlaneElseItIsSmallAgainstTheScene) {
    Scene scene = with_camera();
    EXPECT_NEAR(complete(scene, {}).completed->view.near, 1e-6 * std::sqrt(3.0), 1e-9); // the unit sphere's box
    scene.cameras[0].hither = 0.25;
    EXPECT_EQ(complete(scene, {}).completed->view.near, 0.25);
}

TEST(PlanComplete, AnEmptySceneStillHasACamera) {
    Scene scene;
    scene.materials.emplace_back();
    EXPECT_TRUE(complete(scene, {}).completed);
    EXPECT_EQ(scene.cameras.size(), 1u);
}

TEST(PlanComplete, TheLoadersRemarksBecomeLines) {
    Scene scene = with_camera();
    scene.remarks = {"OBJ Ka is not used"};
    EXPECT_EQ(reason_of(complete(scene, {}).completed->notes, "file"), "OBJ Ka is not used");
}

} // namespace
} // namespace lightbench
