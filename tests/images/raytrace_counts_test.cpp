// How many rays are sent (S19, S35): none that nothing calls for, whose code then is in no pipeline; and as many as Haines published.
#include "images/ray_reference.h"
#include "render/raster.h"
#include "render/raytrace.h"
#include "scene/load.h"
#include "scene/make.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace lightbench::testing {
namespace {

Scene lit_ball() {
    Scene scene = plane_scene({3, 4, 6});
    Object ball;
    ball.shape = Sphere{{0, 1.2, 0}, 1};
    scene.objects.push_back(ball);
    scene.materials[0].reflection = glm::vec3(0);
    scene.lights = {point_light({-2, 4, 2}, glm::vec3(3), Attenuation::linear)};
    return scene;
}

RayStatistics counted(const Scene& scene, unsigned depth = 5, float cutoff = 0) {
    Request request = ray_request({64, 48}, depth);
    request.count = true, request.cutoff = cutoff;
    return render_scene(scene, request).output.rays.value();
}

TEST(RayCounts, NoRayIsSentThatNothingCallsFor) {
    Scene scene = lit_ball();
    const RayStatistics plain = counted(scene);
    EXPECT_EQ(plain.eye, 64u * 48);
    EXPECT_GT(plain.eye_hit, 1000u);
    EXPECT_GT(plain.shadow, 1000u);
    EXPECT_LE(plain.shadow, plain.eye_hit);
    EXPECT_EQ(plain.reflected + plain.refracted + plain.straight, 0u);

    scene.materials[0].reflection = glm::vec3(0.5f);
    EXPECT_EQ(counted(scene, 2).reflected, plain.eye_hit);
    EXPECT_EQ(counted(scene, 1).reflected, 0u) << "the depth is reached";
    EXPECT_EQ(counted(scene, 5, 0.6f).reflected, 0u) << "their weight is below the cutoff";
    EXPECT_EQ(counted(scene, 5, 0.4f).reflected, plain.eye_hit) << "their children's is";
    EXPECT_EQ(counted(scene).refracted, 0u);

    scene.lights.clear(), scene.materials[0].diffuse = glm::vec3(0), scene.materials[0].emission = glm::vec3(1);
    EXPECT_EQ(counted(scene).shadow, 0u) << "a headlight is added, but nothing answers to it";
    scene.lights = {point_light({-2, -4, 2}, glm::vec3(3))};
    scene.materials[0].diffuse = glm::vec3(1), scene.objects.pop_back();
    EXPECT_EQ(counted(scene).shadow, 0u) << "the light is behind the plane";
    scene.lights = {point_light({-2, 4, 2}, glm::vec3(0))};
    EXPECT_EQ(counted(scene).shadow, 0u) << "the light is dark";
}

// The pipelines of a plan, by pass, as the driver gets them.
std::map<RayPass, gpu::Stage> pipelines_of(const Scene& scene, Request request) {
    const Rendered r = render_scene(scene, request);
    GpuScene on_gpu = upload_scene(test_device(), scene, r.geometry, r.plan);
    RayTracer tracer = make_ray_tracer(test_device(), scene, r.geometry, r.plan);
    gpu::Recorder recorder(test_device());
    RasterTargets targets = make_targets(test_device(), r.plan.size, 1, "radiance");
    gpu::Timings times;
    warm_up(tracer, {test_device(), recorder, r.plan, on_gpu, r.geometry, times, {}}, {r.view, r.plan.crop}, targets.resolved);
    std::map<RayPass, gpu::Stage> out;
    for (const auto& [key, pipeline] : tracer.pipelines) out[key.first] = pipeline.stage();
    return out;
}

std::set<std::uint32_t> opcodes_of(const gpu::Stage& stage) {
    std::set<std::uint32_t> out;
    for (std::size_t i = 5; i < stage.words.size(); i += std::max(stage.words[i] >> 16, 1u)) out.insert(stage.words[i] & 0xffff);
    return out;
}

constexpr std::uint32_t kOpAtomicIAdd = 234, kOpGroupNonUniformIAdd = 349; // only allocate() adds over a SIMD group

TEST(RayCounts, WhatSendsNoRayHasNoCodeForIt) {
    Scene scene = lit_ball();
    const auto plain = pipelines_of(scene, ray_request());
    const gpu::Stage& shade = plain.at(RayPass::shade);
    EXPECT_FALSE(opcodes_of(shade).contains(kOpGroupNonUniformIAdd));
    EXPECT_EQ(shade.reflection.find("NextRays"), nullptr);
    EXPECT_EQ(shade.reflection.find("media"), nullptr);
    EXPECT_TRUE(plain.contains(RayPass::shadow));
    EXPECT_NE(plain.at(RayPass::light).reflection.find("lit"), nullptr);

    // The control: what is looked for is there where the scene calls for it.
    scene.materials[0].reflection = glm::vec3(0.5f);
    const auto mirrors = pipelines_of(scene, ray_request());
    EXPECT_TRUE(opcodes_of(mirrors.at(RayPass::shade)).contains(kOpGroupNonUniformIAdd));
    EXPECT_NE(mirrors.at(RayPass::shade).reflection.find("NextRays"), nullptr);
    EXPECT_EQ(mirrors.at(RayPass::shade).reflection.find("NextMedia"), nullptr);
    scene.materials[0].transmission = glm::vec3(0.5f);
    const auto glass = pipelines_of(scene, ray_request());
    EXPECT_NE(glass.at(RayPass::shade).reflection.find("NextMedia"), nullptr);
    EXPECT_GT(glass.at(RayPass::shade).words.size(), mirrors.at(RayPass::shade).words.size());
    EXPECT_GT(mirrors.at(RayPass::shade).words.size(), shade.words.size());

    Scene glowing = lit_ball();
    glowing.materials[0].diffuse = glm::vec3(0), glowing.materials[0].emission = glm::vec3(1);
    const auto unlit = pipelines_of(glowing, ray_request());
    EXPECT_FALSE(unlit.contains(RayPass::shadow));
    EXPECT_EQ(unlit.at(RayPass::light).reflection.find("lit"), nullptr);
    EXPECT_EQ(unlit.at(RayPass::light).reflection.find("lights"), nullptr);
}

// Haines 1987, table of his article, 513 x 513 rays through the corners of pixels, depth 5. Here: 512 x 512 through their centers.
struct Published {
    const char* file;
    double eye_hit, reflected, refracted, shadow;
};

constexpr Published kPublished[] = {
    {"balls_4.nff", 263169, 175095, 0, 954368}, {"teapot_12.nff", 161120, 225248, 0, 407656}, {"tetra_6.nff", 49788, 0, 0, 46112}};

class HainesCounts : public ::testing::TestWithParam<Published> {};

TEST_P(HainesCounts, ComeOutWithinTwoPercent) {
    const Published& want = GetParam();
    const char* folder = std::getenv("LIGHTBENCH_NFF_SCENES");
    const std::filesystem::path file = std::filesystem::path(folder ? folder : LIGHTBENCH_SOURCE "/../shared/scenes") / want.file;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file.string() << "; LIGHTBENCH_NFF_SCENES names their folder";
    Loaded loaded = load_scene(file);
    ASSERT_TRUE(loaded.scene);
    Request request = ray_request({512, 512}, 5);
    request.count = true;
    const RayStatistics rays = render_scene(*loaded.scene, request).output.rays.value();
    const double share = 512.0 * 512 / (513.0 * 513);
    const auto expect_near = [&](const char* kind, std::uint64_t got, double published) {
        EXPECT_NEAR(double(got), share * published, 0.02 * share * published) << kind;
    };
    expect_near("eye rays that hit", rays.eye_hit, want.eye_hit);
    expect_near("reflected", rays.reflected, want.reflected);
    expect_near("refracted", rays.refracted, want.refracted);
    expect_near("shadow", rays.shadow, want.shadow);
}

std::string name_of(const ::testing::TestParamInfo<Published>& test) {
    const std::string file = test.param.file;
    return file.substr(0, file.find('_'));
}

INSTANTIATE_TEST_SUITE_P(Published, HainesCounts, ::testing::ValuesIn(kPublished), name_of);

// The same geometry by our own generator.
TEST(RayCounts, TheSphereflakeIsHainesBalls) {
    auto made = make_scene("sphereflake", {{"depth", "4"}});
    ASSERT_TRUE(std::holds_alternative<Scene>(made));
    Scene scene = std::get<Scene>(made);
    std::size_t spheres = 0;
    for (const Object& o : scene.objects) spheres += std::holds_alternative<Sphere>(o.shape);
    EXPECT_EQ(spheres, 7381u);
    Request request = ray_request({512, 512}, 5);
    request.count = true;
    const RayStatistics rays = render_scene(scene, request).output.rays.value();
    const double share = 512.0 * 512 / (513.0 * 513);
    RecordProperty("reflected", int(rays.reflected)), RecordProperty("shadow", int(rays.shadow));
    EXPECT_NEAR(double(rays.eye_hit), share * 263169, 0.02 * 263169);
    EXPECT_NEAR(double(rays.reflected), share * 175095, 0.02 * 175095);
    EXPECT_NEAR(double(rays.shadow), share * 954368, 0.02 * 954368);
}

} // namespace
} // namespace lightbench::testing
