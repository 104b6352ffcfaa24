// The effects table: each bit is set when the scene calls for it, and only then, with a reason that is true.
#include "plan/effects.h"
#include "plan_scenes.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <bit>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using namespace testing;

TEST(PlanEffects, OneDirectionalLightAndNoSpecularMaterial) {
    const Plan plan = plan_of(lit_sphere(LightType::directional));
    EXPECT_EQ(plan.effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT);
    EXPECT_EQ(reason_of(plan.skipped, "specular"), "no material has ks > 0");
    EXPECT_EQ(reason_of(plan.skipped, "ambient"), "the ambient light is 0");
    EXPECT_EQ(reason_of(plan.skipped, "emission"), "no material glows");
    EXPECT_EQ(reason_of(plan.skipped, "point light"), "no point light");
    EXPECT_EQ(reason_of(plan.skipped, "attenuation: linear"), "no light has a distance");
    EXPECT_EQ(reason_of(plan.skipped, "two-sided"), "no surface is seen from behind");
    EXPECT_EQ(reason_of(plan.skipped, "many-materials"), "every surface has the same material");
    EXPECT_EQ(reason_of(plan.skipped, "texture"), "no material has a picture");
    EXPECT_EQ(reason_of(plan.skipped, "transparency"), "every opacity is 1");
    EXPECT_EQ(reason_of(plan.wanted, "diffuse"), "the material has kd > 0");
    EXPECT_EQ(reason_of(plan.wanted, "directional light"), "1 light");
    EXPECT_TRUE(plan.fallbacks.empty());
}

TEST(PlanEffects, EveryRowHasItsOwnBitAndEveryEffectALine) {
    std::uint32_t bits = 0, ray_bits = 0;
    for (const Effect& effect : effects()) {
        EXPECT_EQ(bits & effect.bit, 0u) << effect.name;
        EXPECT_EQ(ray_bits & effect.ray_bit, 0u) << effect.name;
        EXPECT_NE(effect.bit | effect.ray_bit, 0u) << effect.name;
        bits |= effect.bit, ray_bits |= effect.ray_bit;
        EXPECT_TRUE(effect.instead.empty() || effect.bit == 0u) << effect.name << ": drawn, and something else in its place";
    }
    EXPECT_EQ(bits, 0xffffffffu) << "a bit of shared/effects.h has no row";
    const Plan plan = plan_of(lit_sphere());
    EXPECT_EQ(plan.wanted.size() + plan.skipped.size() + plan.fallbacks.size(), effects().size());
    EXPECT_EQ(plan.wanted.size(), static_cast<std::size_t>(std::popcount(plan.effects)));
}

TEST(PlanEffects, SpecularNeedsALightAndKs) {
    Scene scene = bare_sphere();
    scene.materials[0].specular = glm::vec3(0, 0.1f, 0);
    EXPECT_EQ(reason_of(plan_of(scene).skipped, "specular"), "there is no light");
    scene.lights.push_back(light_of(LightType::point));
    EXPECT_TRUE(plan_of(scene).effects & EFFECT_SPECULAR);
    scene.materials.resize(3);
    scene.objects.push_back({Sphere{}, 1});
    scene.objects.push_back({Sphere{}, 2});
    EXPECT_EQ(reason_of(plan_of(scene).wanted, "specular"), "1 of 3 materials has ks > 0");
}

TEST(PlanEffects, AmbientNeedsBothIaAndKd) {
    Scene scene = bare_sphere();
    scene.environment.ambient = glm::vec3(0.1f);
    EXPECT_EQ(plan_of(scene).effects, EFFECT_AMBIENT);
    scene.materials[0].diffuse = glm::vec3(0);
    EXPECT_EQ(plan_of(scene).effects, 0u);
    EXPECT_EQ(reason_of(plan_of(scene).skipped, "ambient"), "no material has kd > 0");
}

// A black body under lamps: none of the lamps' bits can change its image.
TEST(PlanEffects, LightsThatNothingAnswersAreFilteredOut) {
    Scene scene = with_lights(20);
    scene.materials[0].diffuse = glm::vec3(0);
    scene.materials[0].emission = glm::vec3(3);
    const Plan plan = plan_of(scene);
    EXPECT_EQ(plan.effects, EFFECT_EMISSION);
    EXPECT_FALSE(plan.has("lights"));
    EXPECT_EQ(reason_of(plan.skipped, "point light"), "20 lights, but no material has kd > 0 or ks > 0");
}

TEST(PlanEffects, EachLawSetsItsOwnBit) {
    EXPECT_EQ(plan_of(lit_sphere(LightType::point, Attenuation::none)).effects,
              EFFECT_DIFFUSE | EFFECT_POINT_LIGHT | EFFECT_ATTENUATION_NONE);
    EXPECT_EQ(plan_of(lit_sphere(LightType::spot, Attenuation::linear)).effects,
              EFFECT_DIFFUSE | EFFECT_SPOT_LIGHT | EFFECT_ATTENUATION_LINEAR);
    EXPECT_EQ(plan_of(lit_sphere(LightType::point, Attenuation::inverse_square)).effects,
              EFFECT_DIFFUSE | EFFECT_POINT_LIGHT | EFFECT_ATTENUATION_INVERSE_SQUARE);
    EXPECT_EQ(reason_of(plan_of(lit_sphere(LightType::point)).skipped, "attenuation: inverse-square"), "no light uses it");
}

// (n - 1) u <= 8 u up to nine lights.
TEST(PlanEffects, TheSumIsCompensatedFromTenLightsOn) {
    EXPECT_FALSE(plan_of(with_lights(9)).effects & EFFECT_COMPENSATED_SUM);
    EXPECT_TRUE(plan_of(with_lights(10)).effects & EFFECT_COMPENSATED_SUM);
}

TEST(PlanEffects, TwoSidedWhereSomethingIsOpenAndLit) {
    Scene scene = lit_sphere();
    scene.objects.push_back({Polygon{}});
    EXPECT_TRUE(plan_of(scene).effects & EFFECT_TWO_SIDED);
    EXPECT_EQ(reason_of(plan_of(scene).wanted, "two-sided"), "1 of 2 objects may be seen from behind");
    scene.lights.clear();
    EXPECT_FALSE(plan_of(scene).effects & EFFECT_TWO_SIDED);
}

TEST(PlanEffects, ClosedMeshesLoseTheBitOnceTessellated) {
    Scene scene = lit_sphere();
    scene.meshes.emplace_back().face_starts = {0};
    scene.objects.push_back({MeshUse{0}});
    Facts facts = gather_facts(scene);
    EXPECT_TRUE(decide(facts, {}).effects & EFFECT_TWO_SIDED);
    facts.geometry = GeometryFacts{};
    EXPECT_FALSE(decide(facts, {}).effects & EFFECT_TWO_SIDED);
    facts.geometry->faces_two_sided = 1;
    EXPECT_TRUE(decide(facts, {}).effects & EFFECT_TWO_SIDED);
}

TEST(PlanEffects, VanishingNormalsOnlyWithPhongAndTheFilesOwnNormals) {
    Scene scene = lit_sphere();
    EXPECT_FALSE(plan_of(scene).effects & EFFECT_VANISHING_NORMALS);
    Polygon polygon;
    polygon.normals.resize(3);
    scene.objects.push_back({polygon});
    EXPECT_TRUE(plan_of(scene).effects & EFFECT_VANISHING_NORMALS);
    Request gouraud;
    gouraud.shading = Shading::gouraud;
    EXPECT_FALSE(plan_of(scene, gouraud).effects & EFFECT_VANISHING_NORMALS);
    Facts facts = gather_facts(scene);
    facts.geometry = GeometryFacts{};
    EXPECT_FALSE(decide(facts, {}).effects & EFFECT_VANISHING_NORMALS);
    facts.geometry->normals_may_vanish = true;
    EXPECT_TRUE(decide(facts, {}).effects & EFFECT_VANISHING_NORMALS);
}

TEST(PlanEffects, ManyMaterialsOnlyIfSeveralAreInUseAndRead) {
    Scene scene = lit_sphere();
    scene.materials.resize(2);
    EXPECT_FALSE(plan_of(scene).effects & EFFECT_MANY_MATERIALS);
    scene.objects.push_back({Sphere{}, 1});
    EXPECT_TRUE(plan_of(scene).effects & EFFECT_MANY_MATERIALS);
    scene.lights.clear();
    EXPECT_FALSE(plan_of(scene).effects & EFFECT_MANY_MATERIALS);
}

TEST(PlanEffects, WhatIsNotDrawnYetSaysWhatIsDrawnInstead) {
    Scene scene = lit_sphere();
    Material& m = scene.materials[0];
    m.transmission = glm::vec3(0.1f), m.reflection = glm::vec3(0.2f), m.fresnel = true, m.scatter = 0.1f, m.dispersion = {1.5f, 0.01f};
    const Plan plan = plan_of(scene);
    EXPECT_EQ(reason_of(plan.fallbacks, "scatter"), "1 material: drawn as if polished; the rasteriser knows no rays");
    for (const char* name : {"transmission", "reflection", "fresnel", "dispersion"})
        EXPECT_NE(reason_of(plan.fallbacks, name), "(none)") << name;
    EXPECT_EQ(plan.effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_TRANSPARENCY | EFFECT_TWO_SIDED) << "opacity 1 - kt";
}

Plan ray_plan_of(const Scene& scene, Request request = {}) {
    request.method = Method::raytrace;
    return decide(gather_facts(scene), request);
}

TEST(PlanEffects, RaysAreSentOnlyWhereAMaterialSendsThem) {
    Scene scene = lit_sphere();
    const Plan plain = ray_plan_of(scene);
    EXPECT_EQ(plain.ray_effects, RAY_SHADOWS);
    EXPECT_FALSE(plain.runs("gather"));
    EXPECT_EQ(reason_of(plain.skipped, "reflection"), "every kr is 0");
    Material& m = scene.materials[0];
    m.specular = glm::vec3(0.1f);
    EXPECT_EQ(ray_plan_of(scene).ray_effects, RAY_SHADOWS | RAY_REFLECTED) << "kr is ks where none is named";
    m.reflection = glm::vec3(0);
    EXPECT_EQ(ray_plan_of(scene).ray_effects, RAY_SHADOWS);
    m.transmission = glm::vec3(0.5f);
    const Plan glass = ray_plan_of(scene);
    EXPECT_EQ(glass.ray_effects, RAY_SHADOWS | RAY_CLEAR_SHADOWS | RAY_REFRACTED | RAY_REFLECTED) << "total reflection";
    EXPECT_FALSE(glass.effects & EFFECT_TRANSPARENCY) << "what is transmitted is refracted, not blended";
    EXPECT_TRUE(glass.runs("gather"));
    m.opacity = glm::vec3(0.5f);
    EXPECT_TRUE(ray_plan_of(scene).ray_effects & RAY_STRAIGHT);
}

TEST(PlanEffects, RaysWithoutLightsCastNoShadows) {
    const Plan plan = ray_plan_of(bare_sphere());
    EXPECT_EQ(plan.ray_effects, 0u);
    EXPECT_FALSE(plan.runs("shadow"));
    EXPECT_EQ(reason_of(plan.skipped, "shadows"), "nothing is lit");
}

TEST(PlanEffects, WhatRaysAreAskedForIsInThePlan) {
    Scene scene = lit_sphere();
    scene.materials[0].specular = glm::vec3(0.1f), scene.materials[0].opacity = glm::vec3(0.5f);
    Request request;
    request.cutoff = 0.01f, request.count = true, request.opaque_shadows = true, request.depth = 7;
    const Plan plan = ray_plan_of(scene, request);
    EXPECT_EQ(plan.ray_effects, RAY_SHADOWS | RAY_REFLECTED | RAY_STRAIGHT | RAY_CUTOFF | RAY_COUNT);
    EXPECT_EQ(plan.depth, 7u);
    EXPECT_NE(reason_of(plan.skipped, "shadows: clear").find("--opaque-shadows"), std::string::npos);
}

TEST(PlanEffects, CookTorranceByDistribution) {
    Scene scene = lit_sphere();
    Material& m = scene.materials[0];
    m.model = Model::cook_torrance;
    EXPECT_EQ(plan_of(scene).effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT) << "ks is 0";
    m.specular = glm::vec3(1);
    EXPECT_EQ(plan_of(scene).effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_GAUSSIAN);
    EXPECT_EQ(reason_of(plan_of(scene).skipped, "specular"), "highlights are all by Cook and Torrance");
    m.distribution = Distribution::beckmann;
    EXPECT_EQ(plan_of(scene).effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_BECKMANN);
}

TEST(PlanEffects, TexturesAndTheirMappings) {
    Scene scene = lit_sphere();
    scene.materials[0].texture.emplace();
    EXPECT_EQ(plan_of(scene).effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_CHECKER | EFFECT_MAP_SPHERICAL)
        << "a sphere has no uv of its own";
    scene.materials[0].texture->mapping = Mapping::planar;
    scene.materials[0].texture->picture = 0;
    scene.pictures.emplace_back();
    const Plan plan = plan_of(scene);
    EXPECT_EQ(plan.effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_TEXTURE | EFFECT_MAP_PLANAR);
    EXPECT_TRUE(plan.has("texels"));
    EXPECT_FALSE(plan.has("detail"));
    scene.materials[0].diffuse = glm::vec3(0);
    EXPECT_EQ(reason_of(plan_of(scene).skipped, "texture"), "1 material, but nothing shows its kd");
    EXPECT_FALSE(plan_of(scene).has("texels"));
}

TEST(PlanEffects, BumpsNeedATermThatReadsNormals) {
    Scene scene = lit_sphere();
    scene.materials[0].bump.emplace().function = BumpFunction::waves;
    EXPECT_EQ(plan_of(scene).effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_BUMP_WAVES);
    scene.materials[0].bump->function = BumpFunction::noise;
    EXPECT_EQ(plan_of(scene).effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_BUMP_NOISE);
    scene.lights.clear();
    EXPECT_EQ(reason_of(plan_of(scene).skipped, "bump: noise"), "1 material, but no term reads normals");
}

TEST(PlanEffects, EnvironmentsAreMirroredAndSeenBehind) {
    Scene scene = lit_sphere();
    scene.materials[0].environment = 0.5f;
    EXPECT_EQ(reason_of(ray_plan_of(scene).skipped, "environment: mirrored"), "1 material, but the scene has no map");
    EXPECT_EQ(reason_of(ray_plan_of(scene).skipped, "environment: rendered"), "rays meet the scene itself where kr > 0");
    scene.pictures.resize(6);
    scene.environment.map = {0};
    const Plan one = plan_of(scene);
    EXPECT_EQ(one.effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_MIRROR_ENVIRONMENT | EFFECT_BACKGROUND_MAP);
    EXPECT_TRUE(one.runs("background"));
    scene.environment.map = {0, 1, 2, 3, 4, 5};
    EXPECT_TRUE(plan_of(scene).effects & EFFECT_SIX_FACES);
    scene.environment.map.clear();
    EXPECT_FALSE(plan_of(scene).runs("background"));
}

TEST(PlanEffects, WithoutAMapTheEnvironmentIsRenderedOnce) {
    Scene scene = lit_sphere();
    EXPECT_FALSE(plan_of(scene).runs("environment-cube"));
    EXPECT_EQ(reason_of(plan_of(scene).skipped, "environment: rendered"), "no material mirrors it");
    scene.materials[0].environment = 0.5f;
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        Request request;
        request.shading = shading;
        const Plan plan = plan_of(scene, request);
        EXPECT_EQ(plan.effects,
                  EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_MIRROR_ENVIRONMENT | EFFECT_SIX_FACES | EFFECT_RENDERED_CUBE);
        EXPECT_EQ(pass_names(plan).front(), "environment-cube");
        EXPECT_TRUE(plan.has("texels"));
        EXPECT_FALSE(plan.runs("background"));
    }
    scene.pictures.resize(1);
    scene.environment.map = {0};
    EXPECT_FALSE(plan_of(scene).effects & EFFECT_RENDERED_CUBE);
    EXPECT_EQ(reason_of(plan_of(scene).skipped, "environment: rendered"), "the scene has a map");
}

TEST(PlanEffects, TransparencyIsThreePassesAndSeenFromBehind) {
    Scene scene = lit_sphere();
    EXPECT_FALSE(plan_of(scene).effects & EFFECT_TWO_SIDED);
    scene.materials[0].opacity = glm::vec3(1, 1, 0.5f);
    const Plan plan = plan_of(scene);
    EXPECT_EQ(plan.effects, EFFECT_DIFFUSE | EFFECT_DIRECTIONAL_LIGHT | EFFECT_TRANSPARENCY | EFFECT_TWO_SIDED);
    for (const char* pass : {"count-layers", "list-layers", "blend-layers"}) EXPECT_TRUE(plan.runs(pass)) << pass;
}

TEST(PlanEffects, NamesOfAMask) {
    Plan plan;
    EXPECT_TRUE(effect_names(plan).empty());
    plan.effects = EFFECT_SPECULAR | EFFECT_AMBIENT;
    EXPECT_EQ(effect_names(plan), (std::vector<std::string>{"ambient", "specular"}));
    plan.ray_effects = RAY_REFLECTED;
    EXPECT_EQ(effect_names(plan), (std::vector<std::string>{"ambient", "specular", "reflection"}));
}

} // namespace
} // namespace lightbench
