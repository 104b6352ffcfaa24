// The demonstration scene against its golden pictures, in each shading.
#include "images/golden.h"
#include "images/rendering.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lightbench::testing {
namespace {

void expect_default_scene(const std::string& name, Shading shading) {
    const Loaded loaded = load_scene(fmt::format("{}/assets/scenes/default.toml", LIGHTBENCH_SOURCE));
    ASSERT_TRUE(loaded.scene);
    Request request = radiance_request(shading, {320, 180});
    request.output = Output::pixels, request.spp = 4;
    const Rendered r = render_scene(*loaded.scene, request);
    EXPECT_EQ(r.output.non_finite, 0u);
    const gpu::DeviceInfo& info = test_device().info();
    expect_golden(name, driver_key(info.driver, info.version, info.subgroup_size), *r.output.pixels);
}

TEST(GoldenScenes, DefaultFlat) {
    expect_default_scene("default-flat", Shading::flat);
}
TEST(GoldenScenes, DefaultGouraud) {
    expect_default_scene("default-gouraud", Shading::gouraud);
}
TEST(GoldenScenes, DefaultPhong) {
    expect_default_scene("default-phong", Shading::phong);
}

} // namespace
} // namespace lightbench::testing
