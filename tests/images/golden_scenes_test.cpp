// The scenes of assets/ against their golden pictures: the demonstration in each shading, surface detail and transparency in Phong, and
// two by rays.
#include "images/golden.h"
#include "images/rendering.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lightbench::testing {
namespace {

void expect_scene(const std::string& scene, const std::string& name, Request request) {
    const Loaded loaded = load_scene(fmt::format("{}/assets/scenes/{}.toml", LIGHTBENCH_SOURCE, scene));
    ASSERT_TRUE(loaded.scene);
    request.output = Output::pixels, request.spp = 4;
    const Rendered r = render_scene(*loaded.scene, request);
    EXPECT_EQ(r.output.non_finite, 0u);
    const gpu::DeviceInfo& info = test_device().info();
    expect_golden(name, driver_key(info.driver, info.version, info.subgroup_size), *r.output.pixels);
}

void expect_scene(const std::string& scene, const std::string& name, Shading shading) {
    expect_scene(scene, name, radiance_request(shading, {320, 180}));
}

void expect_rays(const std::string& scene, const std::string& name, unsigned depth) {
    Request request = radiance_request(Shading::phong, {320, 180});
    request.method = Method::raytrace, request.depth = depth;
    request.cutoff = 0.04f;
    expect_scene(scene, name, request);
}

TEST(GoldenScenes, DefaultFlat) {
    expect_scene("default", "default-flat", Shading::flat);
}
TEST(GoldenScenes, DefaultGouraud) {
    expect_scene("default", "default-gouraud", Shading::gouraud);
}
TEST(GoldenScenes, DefaultPhong) {
    expect_scene("default", "default-phong", Shading::phong);
}
TEST(GoldenScenes, Glass) {
    expect_scene("glass", "glass", Shading::phong);
}
TEST(GoldenScenes, Globe) {
    expect_scene("globe", "globe", Shading::phong);
}
TEST(GoldenScenes, Grazing) {
    expect_scene("grazing", "grazing", Shading::phong);
}
TEST(GoldenScenes, Orange) {
    expect_scene("orange", "orange", Shading::phong);
}
TEST(GoldenScenes, Teapot) {
    expect_scene("teapot", "teapot", Shading::phong);
}

TEST(GoldenScenes, DefaultRays) {
    expect_rays("default", "default-rays", 5);
}
TEST(GoldenScenes, LensRays) {
    expect_rays("lens", "lens-rays", 8);
}

} // namespace
} // namespace lightbench::testing
