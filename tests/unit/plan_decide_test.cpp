// The decided plan: passes by walking back from the image, resources that exist only if somebody reads them, samples, layers.
#include "plan/passes.h"
#include "plan_scenes.h"
#include "scene/tessellate.h"
#include "shared/effects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using namespace testing;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Request with(Shading shading, Output output = Output::pixels) {
    Request request;
    request.shading = shading, request.output = output;
    return request;
}

TEST(PlanDecide, EachShadingHasItsOwnPassesAndBuffers) {
    const Scene scene = lit_sphere();
    const Plan flat = plan_of(scene, with(Shading::flat));
    EXPECT_THAT(pass_names(flat), ElementsAre("shade-polygons", "raster", "display"));
    EXPECT_TRUE(flat.has("polygon-colors") && flat.has("polygons") && flat.has("vertices"));
    EXPECT_FALSE(flat.has("normals") || flat.has("vertex-colors"));

    const Plan gouraud = plan_of(scene, with(Shading::gouraud));
    EXPECT_THAT(pass_names(gouraud), ElementsAre("shade-vertices", "raster", "display"));
    EXPECT_TRUE(gouraud.has("vertex-colors") && gouraud.has("normals") && gouraud.has("vertices"));
    EXPECT_FALSE(gouraud.has("polygon-colors") || gouraud.has("polygons"));

    const Plan phong = plan_of(scene, with(Shading::phong));
    EXPECT_THAT(pass_names(phong), ElementsAre("raster", "display"));
    EXPECT_TRUE(phong.has("normals") && phong.has("vertices") && phong.has("lights") && phong.has("materials"));
    EXPECT_FALSE(phong.has("vertex-colors") || phong.has("polygon-colors") || phong.has("polygons"));
}

TEST(PlanDecide, DisplayOnlyForPixels) {
    const Plan plan = plan_of(lit_sphere(), with(Shading::phong, Output::radiance));
    EXPECT_FALSE(plan.runs("display"));
    EXPECT_FALSE(plan.has("pixels") || plan.has("census"));
    EXPECT_TRUE(plan.has("radiance"));
}

TEST(PlanDecide, ExposureOfRadianceIsSaidToBeLeftOut) {
    Request request = with(Shading::phong, Output::radiance);
    EXPECT_EQ(reason_of(plan_of(lit_sphere(), request).fallbacks, "exposure"), "(none)");
    request.exposure = 1;
    EXPECT_EQ(reason_of(plan_of(lit_sphere(), request).fallbacks, "exposure"), "not applied: a file of linear radiance has none");
    EXPECT_EQ(reason_of(plan_of(lit_sphere(), with(Shading::phong)).fallbacks, "exposure"), "(none)");
}

TEST(PlanDecide, Float64IsOfPhongsTermsAtEachPixel) {
    const auto planned = [](Scene scene, Method method, Shading shading) {
        Request request = with(shading);
        request.method = method, request.precision = Precision::float64;
        return plan_of(std::move(scene), request);
    };
    const Plan plan = planned(lit_sphere(), Method::raster, Shading::phong);
    EXPECT_EQ(plan.precision, Precision::float64);
    EXPECT_EQ(reason_of(plan.fallbacks, "precision"), "(none)");
    for (const Plan& other :
         {planned(lit_sphere(), Method::raytrace, Shading::phong), planned(lit_sphere(), Method::raster, Shading::gouraud)}) {
        EXPECT_EQ(other.precision, Precision::float32);
        EXPECT_EQ(reason_of(other.fallbacks, "precision"), "float32: float64 is what the rasteriser has for shading at each pixel");
    }
    Scene metal = lit_sphere();
    metal.materials[0].specular = glm::vec3(1), metal.materials[0].model = Model::cook_torrance;
    EXPECT_EQ(reason_of(planned(metal, Method::raster, Shading::phong).fallbacks, "precision"),
              "float32 for the highlights of Cook and Torrance");
}

TEST(PlanDecide, WithoutLightNoLightsAreRead) {
    Scene scene = bare_sphere();
    scene.environment.ambient = glm::vec3(1);
    const Plan plan = plan_of(scene);
    EXPECT_FALSE(plan.has("lights"));
    EXPECT_TRUE(plan.has("materials"));
    scene.environment.ambient = glm::vec3(0);
    EXPECT_FALSE(plan_of(scene).has("materials"));
}

TEST(PlanDecide, WalkingBackDropsWhatNobodyReads) {
    const std::vector<Pass> chain = {
        {"a", "", {}, {"x"}}, {"unread", "", {"x"}, {"y"}}, {"b", "", {"x"}, {"z"}}, {"late", "", {"z"}, {"w"}}};
    const std::vector<Pass> kept = walk_back(chain, {"z"});
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0].name, "a");
    EXPECT_EQ(kept[1].name, "b");
    EXPECT_TRUE(walk_back(chain, {"nothing"}).empty());
}

// Every resource that a pass reads was uploaded (starts the chain) or was written by an earlier pass.
TEST(PlanDecide, NoPassReadsWhatALaterPassWrites) {
    for (Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        Request request = with(shading, Output::radiance);
        request.terms = true, request.spp = 9;
        const Plan plan = plan_of(lit_sphere(), request);
        for (std::size_t i = 0; i < plan.passes.size(); ++i)
            for (const std::string& read : plan.passes[i].reads)
                for (std::size_t later = i; later < plan.passes.size(); ++later)
                    EXPECT_THAT(plan.passes[later].writes, Not(Contains(read)));
    }
}

TEST(PlanDecide, OneAndFourSamplesAreMultisampling) {
    Request request;
    EXPECT_EQ(plan_of(lit_sphere(), request).multisamples, 1u);
    request.spp = 4;
    Plan plan = plan_of(lit_sphere(), request);
    EXPECT_EQ(plan.multisamples, 4u);
    EXPECT_EQ(plan.frames, 1u);
    EXPECT_FALSE(plan.runs("accumulate"));
    EXPECT_EQ(bytes_of(plan, "radiance-samples"), 1280u * 720 * 16 * 4);
    EXPECT_EQ(bytes_of(plan, "depth"), 1280u * 720 * 4 * 4);
    request.spp = 16;
    plan = plan_of(lit_sphere(), request);
    EXPECT_EQ(plan.multisamples, 1u);
    EXPECT_EQ(plan.frames, 16u);
    EXPECT_THAT(pass_names(plan), ElementsAre("raster", "accumulate", "display"));
    EXPECT_FALSE(plan.has("radiance-samples"));
}

TEST(PlanDecide, ANamedPatternAlwaysAccumulates) {
    Request request;
    request.spp = 4, request.sampling = Sampling::jittered;
    const Plan plan = plan_of(lit_sphere(), request);
    EXPECT_EQ(plan.frames, 4u);
    EXPECT_EQ(plan.multisamples, 1u);
    EXPECT_TRUE(plan.jittered);
}

TEST(PlanDecide, LightsInBoundedPieces) {
    EXPECT_EQ(plan_of(with_lights(kFewLights)).light_count, kFewLights);
    EXPECT_EQ(plan_of(with_lights(kFewLights + 1)).light_count, 0u);
    EXPECT_EQ(plan_of(with_lights(kLightsPerPass)).light_passes, 1u);
    const Plan plan = plan_of(with_lights(kLightsPerPass + 1));
    EXPECT_EQ(plan.light_passes, 2u);
    EXPECT_TRUE(plan.runs("accumulate"));
    EXPECT_EQ(bytes_of(plan, "lights"), 64 * (kLightsPerPass + 1));
}

TEST(PlanDecide, LayersOnlyOfTermsThatAreNotZero) {
    Scene scene = lit_sphere();
    Request request = with(Shading::phong, Output::radiance);
    request.terms = true;
    EXPECT_THAT(plan_of(scene, request).terms, ElementsAre("diffuse", "attenuation", "normal", "depth", "object"));
    scene.environment.background = scene.environment.ambient = glm::vec3(0.1f);
    scene.materials[0].specular = scene.materials[0].emission = glm::vec3(0.1f);
    const Plan plan = plan_of(scene, request);
    EXPECT_THAT(plan.terms,
                ElementsAre("ambient", "diffuse", "specular", "emission", "background", "attenuation", "normal", "depth", "object"));
    EXPECT_TRUE(plan.runs("term-background") && plan.has("layer-object"));
    scene.lights.clear();
    EXPECT_THAT(plan_of(scene, request).terms, ElementsAre("ambient", "emission", "background", "normal", "depth", "object"));
    request.terms = false;
    EXPECT_TRUE(plan_of(scene, request).terms.empty());
}

TEST(PlanDecide, SizesFollowTheTessellation) {
    RasterGeometry geometry;
    geometry.indices.resize(30), geometry.vertices.positions.resize(9), geometry.polygons.positions.resize(4);
    geometry.dropped_degenerate = 2;
    Facts facts = gather_facts(lit_sphere());
    EXPECT_EQ(bytes_of(decide(facts, with(Shading::flat)), "polygon-colors"), 0u);
    add_geometry(facts, geometry);
    const Plan flat = decide(facts, with(Shading::flat));
    EXPECT_EQ(flat.triangles, 10u);
    EXPECT_EQ(bytes_of(flat, "polygon-colors"), 64u);
    EXPECT_EQ(bytes_of(flat, "polygons"), 128u);
    EXPECT_EQ(bytes_of(flat, "indices"), 120u);
    EXPECT_EQ(reason_of(flat.fallbacks, "polygons"), "2 without area: left out");
    EXPECT_EQ(bytes_of(decide(facts, with(Shading::gouraud)), "vertex-colors"), 144u);
}

TEST(PlanDecide, TheCropIsTheWholeImageUnlessAsked) {
    Request request;
    request.size = glm::uvec2(640, 360);
    EXPECT_EQ(plan_of(lit_sphere(), request).crop.size, glm::uvec2(640, 360));
    request.crop = Rect{{10, 20}, {30, 40}};
    const Plan plan = plan_of(lit_sphere(), request);
    EXPECT_EQ(plan.crop.offset, glm::uvec2(10, 20));
    EXPECT_EQ(bytes_of(plan, "pixels"), 30u * 40 * 4);
    EXPECT_EQ(bytes_of(plan, "radiance"), 640u * 360 * 16);
}

TEST(PlanDecide, SaysWhoBuildsTheTreeAndWhy) {
    Request request;
    request.method = Method::raytrace;
    const auto reason = [&] {
        const Plan plan = plan_of(lit_sphere(), request);
        return std::ranges::find(plan.resources, "structure", &Resource::name)->reason;
    };
    EXPECT_THAT(reason(), HasSubstr("built on the host"));
    request.accel_parameters.builder = TreeBuilder::device;
    EXPECT_THAT(reason(), HasSubstr("built on the device as asked"));
    request.accel = Structure::grid;
    EXPECT_THAT(reason(), Not(HasSubstr("built")));
}

} // namespace
} // namespace lightbench
