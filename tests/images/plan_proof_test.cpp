// S35 proven on what the driver gets: the specialised modules, the buffers, the passes of a plan hold nothing that no object or light calls for.
#include "images/rendering.h"

#include "render/raster.h"
#include "render/shaders.h"
#include "shared/effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>

namespace lightbench::testing {
namespace {

// What of a SPIR-V module tells which terms are in it (SPIR-V 1.6 specification, sec. 3.49).
struct Contents {
    std::set<std::uint32_t> constants;     // words of 32-bit OpConstant
    std::multiset<std::uint32_t> extended; // GLSL.std.450 instructions
    std::map<std::uint32_t, unsigned> opcodes;
    bool has_constant(float x) const { return constants.contains(std::bit_cast<std::uint32_t>(x)); }
};

constexpr std::uint32_t kOpExtInst = 12, kOpConstant = 43, kOpSpecConstant = 50, kOpImageFetch = 95, kOpLoopMerge = 246;
constexpr std::uint32_t kInverseSqrt = 32, kFloor = 8;

Contents contents_of(const std::vector<std::uint32_t>& words) {
    Contents c;
    for (std::size_t i = 5; i < words.size();) {
        const std::uint32_t opcode = words[i] & 0xffff, length = words[i] >> 16;
        ++c.opcodes[opcode];
        if (opcode == kOpConstant && length == 4) c.constants.insert(words[i + 3]);
        if (opcode == kOpExtInst) c.extended.insert(words[i + 4]);
        i += std::max(length, 1u);
    }
    return c;
}

constexpr float kInPower = 0.693145751953125f;    // only the specular term takes a power (lib/power.glsl)
constexpr float kInInverseSquare = 12.566370614f; // 4 pi (lib/attenuation.glsl)
constexpr float kInLinear = 1e-18f;               // its clamp

Scene directional_scene() {
    Scene scene = plane_scene({0, 6, 0.5});
    Light sun;
    sun.type = LightType::directional, sun.direction = {0, -1, 0};
    scene.lights = {sun};
    return scene;
}

struct Built {
    Rendered rendered;
    GpuScene scene;
    RasterPipelines pipelines;
};

Built build(const Scene& scene, Shading shading) {
    Rendered r = render_scene(scene, radiance_request(shading));
    GpuScene on_gpu = upload_scene(test_device(), scene, r.geometry, r.plan);
    const RasterVariant variant{r.plan.effects, OUTPUT_RADIANCE, r.plan.multisamples};
    RasterPipelines pipelines = make_raster_pipelines(test_device(), r.plan, on_gpu, r.geometry, variant);
    return {std::move(r), std::move(on_gpu), std::move(pipelines)};
}

const gpu::Stage& fragment_of(const Built& b) {
    return *(b.pipelines.surfaces.two_sided ? b.pipelines.surfaces.two_sided : b.pipelines.surfaces.one_sided).fragment();
}

bool skipped(const Plan& plan, std::string_view effect) {
    return std::ranges::any_of(plan.skipped, [&](const Line& l) { return l.name.find(effect) != std::string::npos && !l.reason.empty(); });
}

TEST(PlanProof, OneDirectionalLightWithoutSpecularHasNoneOfTheOtherTerms) {
    const Built b = build(directional_scene(), Shading::phong);
    EXPECT_TRUE(skipped(b.rendered.plan, "specular"));
    EXPECT_TRUE(skipped(b.rendered.plan, "attenuation"));
    EXPECT_TRUE(skipped(b.rendered.plan, "ambient"));
    const Contents c = contents_of(fragment_of(b).words);
    EXPECT_FALSE(c.has_constant(kInPower));
    EXPECT_FALSE(c.has_constant(kInLinear));
    EXPECT_FALSE(c.has_constant(kInInverseSquare));
    EXPECT_EQ(c.extended.count(kFloor), 0u);
    EXPECT_EQ(c.extended.count(kInverseSqrt), 1u) << "the normal's alone: neither a light's direction nor the viewer's";
    EXPECT_FALSE(c.opcodes.contains(kOpSpecConstant));
    // One light: position, intensity. One material: diffuse.
    EXPECT_EQ(c.opcodes.at(kOpImageFetch), 3u);
}

// The control: the same search finds the terms where the scene calls for them, so that finding nothing above means something.
TEST(PlanProof, TheTermsAreThereWhereTheSceneCallsForThem) {
    Scene scene = directional_scene();
    scene.materials[0].specular = glm::vec3(0.5f);
    EXPECT_TRUE(contents_of(fragment_of(build(scene, Shading::phong)).words).has_constant(kInPower));
    scene.lights = {point_light({0, 2, 0}, glm::vec3(1), Attenuation::linear)};
    const Contents linear = contents_of(fragment_of(build(scene, Shading::phong)).words);
    EXPECT_TRUE(linear.has_constant(kInLinear));
    EXPECT_FALSE(linear.has_constant(kInInverseSquare));
    scene.lights = {point_light({0, 2, 0}, glm::vec3(1), Attenuation::inverse_square)};
    EXPECT_TRUE(contents_of(fragment_of(build(scene, Shading::phong)).words).has_constant(kInInverseSquare));
}

TEST(PlanProof, BuffersAndPassesThatNobodyReadsDoNotExist) {
    const Built phong = build(directional_scene(), Shading::phong), flat = build(directional_scene(), Shading::flat),
                gouraud = build(directional_scene(), Shading::gouraud);
    EXPECT_TRUE(phong.scene.normals && phong.scene.lights && phong.scene.materials);
    EXPECT_FALSE(phong.scene.vertex_colors || phong.scene.polygon_colors || phong.scene.polygon_positions || phong.scene.polygon_objects);
    EXPECT_TRUE(flat.scene.polygon_colors && !flat.scene.normals && !flat.scene.vertex_colors);
    EXPECT_TRUE(gouraud.scene.vertex_colors && gouraud.scene.normals && !gouraud.scene.polygon_colors);
    EXPECT_FALSE(phong.pipelines.shade);
    EXPECT_FALSE(phong.rendered.plan.runs("display")) << "radiance was asked for, not pixels";
    for (const auto& time : phong.rendered.output.times) EXPECT_EQ(time.name, "raster");
    // Interpolated colors need no model in the fragment stage at all.
    EXPECT_TRUE(fragment_of(gouraud).reflection.bindings.empty());
    EXPECT_FALSE(contents_of(fragment_of(gouraud).words).opcodes.contains(kOpLoopMerge));
}

TEST(PlanProof, ASceneWithoutLightTermsBindsNoLights) {
    Scene scene = plane_scene({0, 6, 0.5});
    scene.materials[0].diffuse = glm::vec3(0), scene.materials[0].emission = glm::vec3(1);
    scene.lights = {point_light({0, 2, 0}, glm::vec3(1))};
    const Built b = build(scene, Shading::phong);
    EXPECT_FALSE(b.scene.lights);
    EXPECT_EQ(fragment_of(b).reflection.find("lights"), nullptr);
    EXPECT_EQ(pixel(*b.rendered.output.radiance, 32, 24), glm::dvec3(1));
}

} // namespace
} // namespace lightbench::testing
