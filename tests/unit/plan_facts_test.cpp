// Facts: what is counted, and what is not.
#include "plan_scenes.h"
#include "scene/tessellate.h"

#include <gtest/gtest.h>

namespace lightbench {
namespace {

using namespace testing;

TEST(PlanFacts, DarkLightsAndUnusedMaterialsDoNotCount) {
    Scene scene = lit_sphere();
    scene.lights.push_back(light_of(LightType::point, Attenuation::linear, 0));
    scene.materials.emplace_back().specular = glm::vec3(1); // nobody's
    const Facts facts = gather_facts(scene);
    EXPECT_EQ(facts.lights, 1u);
    EXPECT_EQ(facts.directional_lights, 1u);
    EXPECT_EQ(facts.point_lights, 0u);
    EXPECT_EQ(facts.materials, 1u);
    EXPECT_EQ(facts.materials_listed, 2u);
    EXPECT_EQ(facts.specular_materials, 0u);
}

TEST(PlanFacts, LawsOfDirectionalLightsDoNotCount) {
    Scene scene = lit_sphere(LightType::directional, Attenuation::inverse_square);
    scene.lights.push_back(light_of(LightType::spot, Attenuation::none));
    const Facts facts = gather_facts(scene);
    EXPECT_EQ(facts.inverse_square_lights, 0u);
    EXPECT_EQ(facts.unattenuated_lights, 1u);
    EXPECT_EQ(facts.spot_lights, 1u);
}

TEST(PlanFacts, LightOfOneChannelCounts) {
    Scene scene = bare_sphere();
    scene.lights.push_back(light_of(LightType::point));
    scene.lights.back().intensity = glm::vec3(0, 0, 1e-20f);
    EXPECT_EQ(gather_facts(scene).lights, 1u);
}

TEST(PlanFacts, MaterialsOfFacesCountOnceForManyObjects) {
    Scene scene = bare_sphere();
    scene.materials.resize(4);
    scene.materials[2].emission = glm::vec3(1);
    Mesh mesh;
    mesh.positions.resize(3);
    mesh.corners = {0, 1, 2, 0, 2, 1};
    mesh.face_starts = {0, 3, 6};
    mesh.face_materials = {2, 3};
    scene.meshes.push_back(mesh);
    for (int i = 0; i < 5; ++i) scene.objects.push_back({MeshUse{0}, 1}); // the object's own material gives way to the faces'
    const Facts facts = gather_facts(scene);
    EXPECT_EQ(facts.materials, 3u); // 0 of the sphere, 2 and 3 of the faces
    EXPECT_EQ(facts.emissive_materials, 1u);
    EXPECT_EQ(facts.mesh_faces, 10u);
    EXPECT_EQ(facts.mesh_objects, 5u);
}

TEST(PlanFacts, OpenShapesAreSeenFromBehindUnlessForbidden) {
    Scene scene;
    scene.materials.resize(3);
    scene.materials[1].two_sided = false;
    scene.materials[2].two_sided = true;
    const auto two_sided = [&](Shape shape, std::uint32_t material) {
        scene.objects = {{std::move(shape), material}};
        return gather_facts(scene).two_sided_objects == 1;
    };
    EXPECT_FALSE(two_sided(Sphere{}, 0));
    EXPECT_TRUE(two_sided(Sphere{}, 2));
    EXPECT_TRUE(two_sided(Polygon{}, 0));
    EXPECT_FALSE(two_sided(Polygon{}, 1));
    EXPECT_FALSE(two_sided(Cylinder{}, 0));
    EXPECT_TRUE(two_sided((Cylinder{{}, {0, 1, 0}, 1, false}), 0));
    EXPECT_TRUE(two_sided((Cone{{}, {0, 1, 0}, 1, 0, false}), 0));
    EXPECT_FALSE(two_sided(Torus{}, 0));
    EXPECT_FALSE(two_sided(Box{}, 0));
}

TEST(PlanFacts, MirrorsAreThoseThatSaySo) {
    Scene scene = bare_sphere();
    scene.materials[0].specular = glm::vec3(0.5f);
    EXPECT_EQ(gather_facts(scene).mirror_materials, 0u);
    EXPECT_EQ(gather_facts(scene).reflective_materials, 1u); // kr is ks when absent
    scene.materials[0].reflection = glm::vec3(0);
    EXPECT_EQ(gather_facts(scene).reflective_materials, 0u);
    scene.materials[0].reflection = glm::vec3(0.1f);
    EXPECT_EQ(gather_facts(scene).mirror_materials, 1u);
    scene.materials[0].environment = 1;
    EXPECT_EQ(gather_facts(scene).mirror_materials, 0u); // the environment is what it mirrors
}

TEST(PlanFacts, TessellationRefinesThem) {
    Facts facts = gather_facts(bare_sphere());
    EXPECT_FALSE(facts.geometry);
    RasterGeometry geometry;
    geometry.indices.resize(12);
    geometry.vertices.positions.resize(7);
    geometry.normals_may_vanish = true;
    add_geometry(facts, geometry);
    EXPECT_EQ(facts.geometry->triangles, 4u);
    EXPECT_EQ(facts.geometry->vertices, 7u);
    EXPECT_TRUE(facts.geometry->normals_may_vanish);
}

} // namespace
} // namespace lightbench
