// Scenes edited on the user's word: what is left out, told by the plan; and a camera of the user's own.
#include "plan/complete.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using ::testing::HasSubstr;

Scene ball() {
    Scene scene;
    Material m;
    m.specular = glm::vec3(0.5f), m.texture = Texture{}, m.bump = Bump{};
    m.bump->function = BumpFunction::waves;
    m.opacity = glm::vec3(0.5f), m.transmission = glm::vec3(0.2f), m.environment = 0.3f, m.reflection = glm::vec3(0.4f);
    scene.materials = {m, Material{}};
    scene.objects.push_back({Sphere{}});
    Light light;
    light.position = {0, 4, 0}, light.intensity = glm::vec3(10), light.attenuation = Attenuation::linear;
    scene.lights = {light, light};
    scene.lights[1].type = LightType::directional;
    scene.environment.map = {0};
    return scene;
}

TEST(Edit, LeavesOutWhatIsNamedAndNothingElse) {
    Scene scene = ball();
    EXPECT_EQ(keep_without(scene, kWithoutTexture | kWithoutBump), 1u);
    EXPECT_FALSE(scene.materials[0].texture || scene.materials[0].bump);
    EXPECT_EQ(scene.materials[0].environment, 0.3f);
    EXPECT_EQ(scene.materials[0].opacity, glm::vec3(0.5f));
    EXPECT_EQ(keep_without(scene, kWithoutEnvironment | kWithoutTransparency), 1u);
    EXPECT_EQ(scene.materials[0].opacity, glm::vec3(1));
    EXPECT_EQ(scene.materials[0].transmission, glm::vec3(0));
    EXPECT_TRUE(scene.environment.map.empty());
    EXPECT_EQ(scene.materials[0].reflection, glm::vec3(0.4f));
    EXPECT_EQ(keep_without(scene, kWithoutReflection), 2u); // of the other ks would count
    EXPECT_EQ(keep_without(scene, 31), 0u);
}

TEST(Edit, ThePlanTellsOfEach) {
    Scene scene = ball();
    Request request;
    request.edits.without = kWithoutBump;
    const auto completed = complete(scene, request).completed.value();
    std::string notes;
    for (const Line& line : completed.notes) notes += line.name + ": " + line.reason + "\n";
    EXPECT_THAT(notes, HasSubstr("without bump: materials changed: 1\n"));
}

TEST(Edit, AnOwnCameraStandsInForTheScenes) {
    Scene scene = ball();
    Request request;
    request.placed = Camera{"own", {1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 1.0, 0.5};
    const auto completed = complete(scene, request).completed.value();
    EXPECT_EQ(completed.view.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(completed.view.near, 0.5);
    EXPECT_TRUE(scene.cameras.empty()); // none had to be made up
    EXPECT_EQ(completed.camera, *request.placed);
}

} // namespace
} // namespace lightbench
