// Changes of a scene that must not change its picture, or must change it in a known way (SC-1, SC-2, LI-7, crops, culling, layers).
#include "images/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lightbench::testing {
namespace {

// A sphere, a torus and a floor under lights of all types and laws.
Scene mixed_scene() {
    Scene scene = plane_scene({3, 4, 6});
    scene.environment.ambient = glm::vec3(0.05f), scene.environment.background = {0.1f, 0.2f, 0.4f};
    Material shiny;
    shiny.diffuse = {0.2f, 0.4f, 0.8f}, shiny.specular = glm::vec3(0.5f), shiny.shininess = 40;
    scene.materials.push_back(shiny);
    Object ball, ring;
    ball.shape = Sphere{{0, 1, 0}, 1}, ball.material = 1;
    ring.shape = Torus{{2, 0.5, 1}, {0, 1, 0}, 1, 0.25};
    scene.objects.push_back(ball), scene.objects.push_back(ring);
    scene.lights = lights_of_every_kind();
    return scene;
}

const Shading kAll[] = {Shading::flat, Shading::gouraud, Shading::phong};

TEST(Metamorphic, ScaleByAPowerOfTwoChangesNoBit) {
    for (const Shading shading : kAll) {
        const auto want = render_scene(mixed_scene(), radiance_request(shading)).output.radiance->rgba;
        for (const int k : {-30, -7, 1, 30}) {
            Scene scene = mixed_scene();
            scale_scene(scene, std::ldexp(1.0, k));
            EXPECT_EQ(render_scene(scene, radiance_request(shading)).output.radiance->rgba, want) << "k = " << k;
        }
    }
}

TEST(Metamorphic, TranslationByAHundredKilometresHardlyMatters) {
    const ImageF want = *render_scene(mixed_scene(), radiance_request(Shading::phong)).output.radiance;
    Scene scene = mixed_scene();
    const glm::dvec3 far(1e5, -1e5, 1e5);
    scene.transforms.push_back(glm::dmat4(1));
    scene.transforms.back()[3] = glm::dvec4(far, 1);
    for (Object& o : scene.objects) o.transform = 1;
    for (Camera& c : scene.cameras) c.position += far, c.target += far;
    for (Light& l : scene.lights) l.position += far;
    const ImageF got = *render_scene(scene, radiance_request(Shading::phong)).output.radiance;
    unsigned differ = 0;
    for (std::size_t i = 0; i < got.rgba.size(); i += 4) differ += std::abs(got.rgba[i] - want.rgba[i]) > 1.0f / 255;
    EXPECT_LE(differ, got.rgba.size() / 4 / 1000);
}

TEST(Metamorphic, LightIsLinear) {
    for (const Shading shading : kAll) {
        Scene scene = mixed_scene();
        scene.environment.background = glm::vec3(0), scene.environment.ambient = glm::vec3(0.0625f);
        auto want = render_scene(scene, radiance_request(shading)).output.radiance->rgba;
        for (Light& l : scene.lights) l.intensity *= 16.0f;
        scene.environment.ambient *= 16.0f;
        const auto got = render_scene(scene, radiance_request(shading)).output.radiance->rgba;
        for (std::size_t i = 0; i < want.size(); ++i) ASSERT_EQ(got[i], i % 4 == 3 ? want[i] : 16.0f * want[i]);
    }
}

TEST(Metamorphic, ACropIsThatRegionOfTheWhole) {
    for (const unsigned spp : {1u, 4u, 9u}) {
        Request request = radiance_request(Shading::phong);
        request.spp = spp;
        if (spp == 9) request.sampling = Sampling::jittered;
        const ImageF whole = *render_scene(mixed_scene(), request).output.radiance;
        request.crop = Rect{{13, 7}, {29, 31}};
        const ImageF crop = *render_scene(mixed_scene(), request).output.radiance;
        ASSERT_EQ(crop.width, 29u);
        for (unsigned y = 0; y < 31; ++y)
            for (unsigned x = 0; x < 29; ++x)
                for (int c = 0; c < 4; ++c) ASSERT_EQ(crop.at(x, y)[c], whole.at(x + 13, y + 7)[c]);
    }
}

TEST(Metamorphic, CullingChangesNoPixel) {
    Scene scene = mixed_scene();
    Request request = radiance_request(Shading::phong);
    request.subdivide = 3; // clusters small enough to face away as a whole
    const Rendered culled = render_scene(scene, request);
    RasterGeometry all = culled.geometry;
    std::size_t triangles = 0;
    for (Cluster& c : all.clusters) c.radius = 1e6f, c.cone_axis = glm::vec3(0), c.cone_cutoff = 1, triangles += c.index_count / 3;
    Renderer renderer(test_device(), scene, all, culled.plan);
    const RenderOutput whole = renderer.render(culled.view);
    EXPECT_EQ(whole.triangles_drawn, triangles);
    EXPECT_LT(culled.output.triangles_drawn, triangles);
    EXPECT_EQ(whole.radiance->rgba, culled.output.radiance->rgba);
}

TEST(Metamorphic, TheLightTermsAddUpToTheImage) {
    for (const Shading shading : kAll)
        for (const unsigned spp : {1u, 4u}) {
            Request request = radiance_request(shading);
            request.terms = true, request.spp = spp;
            const Rendered r = render_scene(mixed_scene(), request);
            std::vector<float> sum(r.output.radiance->rgba.size());
            for (const Layer& layer : r.output.layers)
                if (std::ranges::count(std::vector<std::string>{"ambient", "diffuse", "specular", "emission", "background"}, layer.name))
                    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += layer.image.rgba[i];
            ASSERT_GE(r.output.layers.size(), 7u);
            for (std::size_t i = 0; i < sum.size(); ++i)
                if (i % 4 != 3) {
                    ASSERT_NEAR(sum[i], r.output.radiance->rgba[i], 2e-6f * (1 + std::abs(sum[i])));
                }
        }
}

TEST(Metamorphic, OppositeNormalsLeaveNoHole) {
    Scene scene = plane_scene({0, 6, 0.5});
    auto& plane = std::get<Polygon>(scene.objects[0].shape);
    plane.normals = {{0, 1, 0}, {0, -1, 0}, {0, 1, 0}, {0, -1, 0}};
    scene.lights = {point_light({0, 3, 0}, glm::vec3(1))};
    const Rendered r = render_scene(scene, radiance_request(Shading::phong, {63, 47}));
    EXPECT_TRUE(r.plan.effects != 0);
    EXPECT_EQ(r.output.non_finite, 0u);
}

// Closed shapes alone: no variant of the shaders may then speak of back sides.
TEST(Metamorphic, OneSidedScenesRender) {
    Scene scene = mixed_scene();
    scene.objects.erase(scene.objects.begin()); // the floor
    for (const Shading shading : kAll) {
        const Rendered r = render_scene(scene, radiance_request(shading));
        EXPECT_EQ(r.geometry.one_sided_clusters, r.geometry.clusters.size());
        EXPECT_GT(pixel(*r.output.radiance, 32, 24).z, 0.05);
    }
}

TEST(Metamorphic, RunsAreIdentical) {
    const auto want = render_scene(mixed_scene(), radiance_request(Shading::phong)).output.radiance->rgba;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(render_scene(mixed_scene(), radiance_request(Shading::phong)).output.radiance->rgba, want);
}

} // namespace
} // namespace lightbench::testing
