// Every key of a native scene arrives where Scene keeps it, in the units of Scene.
#include "scene/toml_load.h"
#include "unit/load_fixtures.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace lightbench {
namespace {

using namespace testing_files;
constexpr double kPi = std::numbers::pi;

Scene scene_from(std::string_view text) {
    return scene_of(load_toml(text, "room.toml", {}));
}

template <class Wanted> const Wanted& shape_of(const Scene& scene, std::size_t object = 0) {
    return std::get<Wanted>(scene.objects.at(object).shape);
}

TEST(LoadToml, FilmCameraEnvironment) {
    const Folder folder;
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"}) folder.write(fmt::format("{}.png", face), "x");
    const auto file = folder.write("room.toml", R"(
[film]
width = 640
height = 360
[[camera]]
name = "front"
position = [1, 2, 3.5]
target = [0, 0.5, 0]
up = [0, 0, 1]
fov = 60
hither = 0.25
[[camera]]
[environment]
background = [0.1, 0.2, 0.3]
ambient = 0.5
map = ["px.png", "nx.png", "py.png", "ny.png", "pz.png", "px.png"]
)");
    const Scene s = scene_of(load_scene(file));
    EXPECT_EQ(s.name, "room.toml");
    EXPECT_EQ(s.film, glm::uvec2(640, 360));
    ASSERT_EQ(s.cameras.size(), 2u);
    const Camera& c = s.cameras[0];
    EXPECT_EQ(c.name, "front");
    EXPECT_EQ(c.position, glm::dvec3(1, 2, 3.5));
    EXPECT_EQ(c.target, glm::dvec3(0, 0.5, 0));
    EXPECT_EQ(c.up, glm::dvec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(c.fov, kPi / 3);
    EXPECT_EQ(c.hither, 0.25);
    EXPECT_EQ(s.cameras[1].name, "camera 2");
    EXPECT_DOUBLE_EQ(s.cameras[1].fov, kPi / 4);
    EXPECT_EQ(s.environment.background, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(s.environment.ambient, glm::vec3(0.5f));
    EXPECT_EQ(s.environment.map, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 0}));
    ASSERT_EQ(s.pictures.size(), 5u);
    EXPECT_EQ(s.pictures[1].file, folder.path() / "nx.png");
}

TEST(LoadToml, OneCameraMayStandAlone) {
    const Scene s = scene_from("camera = {position = [0, 0, 9], fov = 90}");
    ASSERT_EQ(s.cameras.size(), 1u);
    EXPECT_EQ(s.cameras[0].position.z, 9);
    EXPECT_DOUBLE_EQ(s.cameras[0].fov, kPi / 2);
}

TEST(LoadToml, AnEmptyFileIsAnEmptySceneWithAMaterial) {
    const Scene s = scene_from("");
    EXPECT_TRUE(s.objects.empty());
    EXPECT_TRUE(s.cameras.empty());
    EXPECT_TRUE(s.lights.empty());
    EXPECT_EQ(s.materials.size(), 1u);
}

TEST(LoadToml, Lights) {
    const Scene s = scene_from(R"(
[[light]]
position = [1, 2, 3]
[[light]]
type = "directional"
direction = [0, 0, -2]
color = [1, 0.5, 0.25]
intensity = 4
attenuation = "none"
[[light]]
type = "spot"
position = [0, 5, 0]
direction = [3, -4, 0]
intensity = [2, 4, 8]
color = 0.5
attenuation = "inverse-square"
d0 = 2.5
angle = 30
softness = 0.75
)");
    ASSERT_EQ(s.lights.size(), 3u);
    EXPECT_EQ(s.lights[0].type, LightType::point);
    EXPECT_EQ(s.lights[0].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(s.lights[0].intensity, glm::vec3(1));
    EXPECT_EQ(s.lights[0].attenuation, Attenuation::linear);
    EXPECT_EQ(s.lights[0].d0, 1);
    EXPECT_EQ(s.lights[1].type, LightType::directional);
    EXPECT_EQ(s.lights[1].direction, glm::dvec3(0, 0, -1));
    EXPECT_EQ(s.lights[1].intensity, glm::vec3(4, 2, 1));
    EXPECT_EQ(s.lights[1].attenuation, Attenuation::none);
    const Light& spot = s.lights[2];
    EXPECT_EQ(spot.type, LightType::spot);
    EXPECT_NEAR(glm::distance(spot.direction, glm::dvec3(0.6, -0.8, 0)), 0, 1e-15);
    EXPECT_EQ(spot.intensity, glm::vec3(1, 2, 4));
    EXPECT_EQ(spot.attenuation, Attenuation::inverse_square);
    EXPECT_EQ(spot.d0, 2.5);
    EXPECT_DOUBLE_EQ(spot.angle, kPi / 6); // the half-angle
    EXPECT_EQ(spot.softness, 0.75);
    EXPECT_TRUE(s.remarks.empty());
}

TEST(LoadToml, WhatALightCannotUseIsARemark) {
    const Scene s = scene_from("[[light]]\nposition = [0, 1, 0]\nangle = 20\n");
    EXPECT_THAT(s.remarks, testing::ElementsAre("light at line 3: a point light has no angle"));
}

TEST(LoadToml, Materials) {
    const Scene s = scene_from(R"(
[[material]]
name = "brass"
diffuse = [0.1, 0.2, 0.3]
specular = 0.5
shininess = 100000
model = "cook-torrance"
distribution = "beckmann"
roughness = 0.25
ior = [1.4, 1.5, 1.6]
f0 = [0.9, 0.7, 0]
fresnel = true
reflection = [0.1, 0, 1]
transmission = 0.75
scatter = 0.05
dispersion = [1.5, 0.0042]
opacity = [1, 0.5, 0]
emission = [10, 20, 30]
two_sided = false
environment = 0.125
texture = {checker = true, mapping = "spherical", scale = [4, 8]}
bump = {function = "noise", amplitude = 0.5, frequency = 12}
[[material]]
name = "plain"
)");
    ASSERT_EQ(s.materials.size(), 2u);
    const Material& m = s.materials[0];
    EXPECT_EQ(m.name, "brass");
    EXPECT_EQ(m.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.specular, glm::vec3(0.5f));
    EXPECT_EQ(m.shininess, 100000.0f);
    EXPECT_EQ(m.model, Model::cook_torrance);
    EXPECT_EQ(m.distribution, Distribution::beckmann);
    EXPECT_EQ(m.roughness, 0.25f);
    EXPECT_EQ(m.ior, glm::vec3(1.4f, 1.5f, 1.6f));
    EXPECT_EQ(m.f0, glm::vec3(0.9f, 0.7f, 0));
    EXPECT_TRUE(m.fresnel);
    EXPECT_EQ(m.reflection, glm::vec3(0.1f, 0, 1));
    EXPECT_EQ(m.transmission, glm::vec3(0.75f));
    EXPECT_EQ(m.scatter, 0.05f);
    EXPECT_EQ(m.dispersion, glm::vec2(1.5f, 0.0042f));
    EXPECT_EQ(m.opacity, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(m.emission, glm::vec3(10, 20, 30));
    EXPECT_EQ(m.two_sided, false);
    EXPECT_EQ(m.environment, 0.125f);
    EXPECT_EQ(m.texture, (Texture{std::nullopt, Mapping::spherical, {4, 8}}));
    EXPECT_EQ(m.bump, (Bump{std::nullopt, false, BumpFunction::noise, 0.5, 12}));
    Material plain;
    plain.name = "plain";
    EXPECT_EQ(s.materials[1], plain); // every default is Scene's
}

TEST(LoadToml, DispersionAsOneNumberKeepsTheIndexAtGreen) {
    const Scene s = scene_from("[[material]]\nname = \"flint\"\nior = 1.62\ndispersion = 0.0121\n");
    const glm::vec2 ab = s.materials[0].dispersion;
    EXPECT_EQ(ab.y, 0.0121f);
    EXPECT_NEAR(ab.x + ab.y / (0.55f * 0.55f), 1.62f, 1e-6);
}

TEST(LoadToml, PicturesAreSharedByFile) {
    const Folder folder;
    folder.write("wood.png", "x");
    const auto file = folder.write("room.toml", R"(
[[material]]
name = "a"
texture = {file = "wood.png", mapping = "planar", scale = 2}
bump = {file = "wood.png", normal_map = true}
[[material]]
name = "b"
texture = {file = "wood.png"}
)");
    const Scene s = scene_of(load_scene(file));
    EXPECT_EQ(s.pictures.size(), 1u);
    EXPECT_EQ(s.materials[0].texture, (Texture{0, Mapping::planar, {2, 2}}));
    EXPECT_EQ(s.materials[0].bump->picture, 0u);
    EXPECT_TRUE(s.materials[0].bump->normal_map);
    EXPECT_EQ(s.materials[1].texture->picture, 0u);
}

TEST(LoadToml, Shapes) {
    const Scene s = scene_from(R"(
[[object]]
shape = "sphere"
center = [1, 2, 3]
radius = 0.5
[[object]]
shape = "polygon"
points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0.2, 0.2, 0]]
normals = [[0, 0, 2], [0, 0, 1], [0, 0, 1], [0, 3, 4]]
[[object]]
shape = "box"
min = [-1, -2, -3]
max = [1, 2, 3]
[[object]]
shape = "cylinder"
base = [0, 1, 0]
top = [0, 3, 0]
radius = 0.25
capped = false
[[object]]
shape = "cone"
base = [0, 0, 0]
apex = [0, 0, 2]
base_radius = 1.5
[[object]]
shape = "cone"
top = [1, 0, 0]
base_radius = 0
top_radius = 2
capped = false
[[object]]
shape = "torus"
center = [9, 8, 7]
axis = [0, 0, 5]
major = 3
minor = 0.5
)");
    ASSERT_EQ(s.objects.size(), 7u);
    EXPECT_EQ(shape_of<Sphere>(s).center, glm::dvec3(1, 2, 3));
    EXPECT_EQ(shape_of<Sphere>(s).radius, 0.5);
    const Polygon& p = shape_of<Polygon>(s, 1);
    EXPECT_THAT(p.points, testing::ElementsAre(glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 0), glm::dvec3(0.2, 0.2, 0)));
    EXPECT_THAT(p.normals, testing::ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0.6f, 0.8f)));
    EXPECT_EQ(shape_of<Box>(s, 2).min, glm::dvec3(-1, -2, -3));
    EXPECT_EQ(shape_of<Box>(s, 2).max, glm::dvec3(1, 2, 3));
    const Cylinder& c = shape_of<Cylinder>(s, 3);
    EXPECT_EQ(c.base, glm::dvec3(0, 1, 0));
    EXPECT_EQ(c.top, glm::dvec3(0, 3, 0));
    EXPECT_EQ(c.radius, 0.25);
    EXPECT_FALSE(c.capped);
    const Cone& cone = shape_of<Cone>(s, 4);
    EXPECT_EQ(cone.top, glm::dvec3(0, 0, 2));
    EXPECT_EQ(cone.base_radius, 1.5);
    EXPECT_EQ(cone.top_radius, 0);
    EXPECT_TRUE(cone.capped);
    const Cone& open = shape_of<Cone>(s, 5);
    EXPECT_EQ(open.top, glm::dvec3(1, 0, 0));
    EXPECT_EQ(open.top_radius, 2);
    EXPECT_FALSE(open.capped);
    const Torus& t = shape_of<Torus>(s, 6);
    EXPECT_EQ(t.center, glm::dvec3(9, 8, 7));
    EXPECT_EQ(t.axis, glm::dvec3(0, 0, 1));
    EXPECT_EQ(t.major, 3);
    EXPECT_EQ(t.minor, 0.5);
}

TEST(LoadToml, MaterialsAreFoundByNameAndObjectsWithoutOneShareTheDefault) {
    const Scene s = scene_from(R"(
[[object]]
shape = "sphere"
material = "b"
[[object]]
shape = "sphere"
[[object]]
shape = "sphere"
[[material]]
name = "a"
[[material]]
name = "b"
)");
    EXPECT_EQ(s.objects[0].material, 1u);
    EXPECT_EQ(s.objects[1].material, 2u);
    EXPECT_EQ(s.objects[2].material, 2u);
    ASSERT_EQ(s.materials.size(), 3u);
    EXPECT_EQ(s.materials[2].name, "default");
}

TEST(LoadToml, CreaseAndSubdivide) {
    const Scene s = scene_from("[[object]]\nshape = \"box\"\ncrease = 60\nsubdivide = 8\n[[object]]\nshape = \"box\"\n");
    EXPECT_FLOAT_EQ(s.objects[0].crease, static_cast<float>(kPi / 3));
    EXPECT_EQ(s.objects[0].subdivide, 8);
    EXPECT_FLOAT_EQ(s.objects[1].crease, static_cast<float>(kPi / 6));
    EXPECT_EQ(s.objects[1].subdivide, 0);
}

glm::dvec3 placed(const Scene& s, std::size_t object, glm::dvec3 p) {
    return glm::dvec3(s.transforms.at(s.objects.at(object).transform) * glm::dvec4(p, 1));
}

TEST(LoadToml, TransformIsTranslateZYXScale) {
    const Scene s = scene_from(R"(
[[object]]
shape = "box"
translate = [10, 20, 30]
rotate = [30, 40, 50]
scale = [2, 3, -4]
)");
    // Oracle: each factor applied to the point by hand, in the order of RULINGS: scale, then x, y, z, then the move.
    const double x = 30 * kPi / 180, y = 40 * kPi / 180, z = 50 * kPi / 180;
    glm::dvec3 p = glm::dvec3(0.5, -0.25, 1) * glm::dvec3(2, 3, -4);
    p = {p.x, p.y * std::cos(x) - p.z * std::sin(x), p.y * std::sin(x) + p.z * std::cos(x)};
    p = {p.x * std::cos(y) + p.z * std::sin(y), p.y, -p.x * std::sin(y) + p.z * std::cos(y)};
    p = {p.x * std::cos(z) - p.y * std::sin(z), p.x * std::sin(z) + p.y * std::cos(z), p.z};
    p += glm::dvec3(10, 20, 30);
    EXPECT_NEAR(glm::distance(placed(s, 0, {0.5, -0.25, 1}), p), 0, 1e-14);
}

TEST(LoadToml, QuarterTurnsAreExact) {
    for (int quarter = -8; quarter <= 8; ++quarter) {
        const Scene s = scene_from(fmt::format("[[object]]\nshape = \"box\"\nrotate = [0, 0, {}]\n", quarter * 90));
        const glm::dvec3 wanted[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
        EXPECT_EQ(placed(s, 0, {1, 0, 0}), wanted[quarter & 3]) << quarter;
    }
}

TEST(LoadToml, EqualTransformsAreShared) {
    const Scene s = scene_from(R"(
object = [{shape = "box"}, {shape = "box", scale = 2}, {shape = "sphere", scale = [2, 2, 2]}, {shape = "box", rotate = [0, 0, 0]}]
)");
    EXPECT_EQ(s.transforms.size(), 2u);
    EXPECT_EQ(s.objects[0].transform, 0u);
    EXPECT_EQ(s.objects[1].transform, 1u);
    EXPECT_EQ(s.objects[2].transform, 1u);
    EXPECT_EQ(s.objects[3].transform, 0u);
}

TEST(LoadToml, LineEndsAndByteOrderMarkDoNotMatter) {
    const std::string_view unix_text = "[film]\nwidth = 8\nheight = 4\n[[object]]\nshape = \"sphere\"\n";
    std::string windows = "\xef\xbb\xbf";
    for (char c : unix_text) windows += c == '\n' ? "\r\n" : std::string(1, c);
    const Scene s = scene_from(windows);
    EXPECT_EQ(s.film, glm::uvec2(8, 4));
    EXPECT_EQ(s.objects.size(), 1u);
    EXPECT_THAT(load_toml("[film]\r\nwidth = 8\r\nheight = 0\r\n", "room.toml", {}).problems,
                testing::ElementsAre(testing::Field(&Problem::line, 3u)));
}

} // namespace
} // namespace lightbench
