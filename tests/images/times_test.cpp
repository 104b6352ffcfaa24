// What is said of the time of a picture: the passes' sum against the clock on the wall.
#include "images/rendering.h"
#include "scene/make.h"

#include <chrono>
#include <gtest/gtest.h>

namespace lightbench::testing {
namespace {

// lavapipe draws and computes in one context; once that has drawn, a driver may put the clock of a dispatch off until the dispatch has ended.
TEST(Times, RaysTakeTheirTimeAlsoAfterDrawing) {
    if (!test_device().info().is_cpu) GTEST_SKIP() << "elsewhere the clock on the wall counts mostly what the host does";
    const Scene scene = std::get<Scene>(make_scene("sphereflake", {{"depth", "2"}}));
    render_scene(scene, radiance_request(Shading::phong, {256, 256}));
    Request rays = radiance_request(Shading::phong, {256, 256});
    rays.method = Method::raytrace;
    render_scene(scene, rays); // compiles
    const auto start = std::chrono::steady_clock::now();
    const double said = render_scene(scene, rays).output.device_milliseconds;
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    EXPECT_LT(said, wall.count());
    EXPECT_GT(said, wall.count() / 5) << "of " << wall.count() << " ms, planning and building included";
}

} // namespace
} // namespace lightbench::testing
