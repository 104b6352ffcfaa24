// load(write(scene)) is the scene: every field of every section, for every kind of scene that the program makes and for one that sets all.
#include "scene/load.h"
#include "scene/make.h"
#include "scene/transform.h"
#include "scene/write.h"

#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace lightbench;
using testing::IsEmpty;

namespace {

struct WriteRoundTrip : testing::Test {
    std::filesystem::path folder = std::filesystem::temp_directory_path() / ("lightbench-round-" + std::to_string(getpid()));
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    Scene back(const Scene& scene, const std::string& name) const {
        for (const Problem& p : write_scene(scene, folder / name)) ADD_FAILURE() << to_string(p);
        const Loaded loaded = load_scene(folder / name);
        for (const Problem& p : loaded.problems) ADD_FAILURE() << to_string(p);
        EXPECT_THAT(loaded.scene.value_or(Scene{}).remarks, IsEmpty());
        return loaded.scene.value_or(Scene{});
    }
};

Scene made(std::string_view kind, const MakeArguments& arguments = {}) {
    return std::get<Scene>(make_scene(kind, arguments));
}

bool within_an_ulp(double a, double b) {
    return a == b || std::nextafter(a, b) == b;
}

// Unit vectors are made unit again when read.
void expect_direction(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_LT(glm::distance(a, b), 4e-16);
}

void expect_same(const Camera& a, const Camera& b, bool named) {
    EXPECT_TRUE(!named || a.name == b.name);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.target, b.target);
    EXPECT_EQ(a.up, b.up);
    EXPECT_TRUE(within_an_ulp(a.fov, b.fov)) << a.fov << " " << b.fov;
    EXPECT_EQ(a.hither, b.hither);
}

// What a light of its type does not use is not written.
void expect_same(const Light& a, const Light& b) {
    EXPECT_EQ(a.type, b.type);
    EXPECT_EQ(a.intensity, b.intensity);
    EXPECT_EQ(a.attenuation, b.attenuation);
    EXPECT_EQ(a.d0, b.d0);
    if (a.type != LightType::directional) {
        EXPECT_EQ(a.position, b.position);
    }
    if (a.type != LightType::point) expect_direction(a.direction, b.direction);
    if (a.type != LightType::spot) return;
    EXPECT_TRUE(within_an_ulp(a.angle, b.angle)) << a.angle << " " << b.angle;
    EXPECT_EQ(a.softness, b.softness);
}

void expect_same(const Sphere& a, const Sphere& b) {
    EXPECT_TRUE(a.center == b.center && a.radius == b.radius);
}
void expect_same(const Box& a, const Box& b) {
    EXPECT_TRUE(a.min == b.min && a.max == b.max);
}
void expect_same(const Cylinder& a, const Cylinder& b) {
    EXPECT_TRUE(a.base == b.base && a.top == b.top && a.radius == b.radius && a.capped == b.capped);
}
void expect_same(const Cone& a, const Cone& b) {
    EXPECT_TRUE(a.base == b.base && a.top == b.top && a.base_radius == b.base_radius && a.top_radius == b.top_radius &&
                a.capped == b.capped);
}
void expect_same(const Torus& a, const Torus& b) {
    EXPECT_TRUE(a.center == b.center && a.major == b.major && a.minor == b.minor);
    expect_direction(a.axis, b.axis);
}
void expect_same(const Polygon& a, const Polygon& b) {
    EXPECT_EQ(a.points, b.points);
    ASSERT_EQ(a.normals.size(), b.normals.size());
    for (std::size_t i = 0; i < a.normals.size(); ++i) EXPECT_LT(glm::distance(a.normals[i], b.normals[i]), 2e-7f);
}
void expect_same(const MeshUse&, const MeshUse&) {} // see expect_same(Mesh, Mesh)

// Face by face; how the corners share vertices is up to the reader. `ulps`: the library that reads OBJ rounds its decimals with floats.
void expect_same(const Mesh& a, const Mesh& b, int ulps) {
    ASSERT_EQ(a.face_starts, b.face_starts);
    ASSERT_EQ(a.normals.empty(), b.normals.empty());
    for (std::size_t c = 0; c < a.corners.size(); ++c) {
        const glm::vec3 p = a.positions[a.corners[c]], q = b.positions[b.corners[c]];
        for (int i = 0; i < 3; ++i)
            ASSERT_LE(std::fabs(p[i] - q[i]), static_cast<float>(ulps) * 1.2e-7f * std::fabs(p[i])) << "corner " << c << " of " << a.name;
        if (!a.normals.empty()) {
            ASSERT_LT(glm::distance(a.normals[a.corners[c]], b.normals[b.corners[c]]), 2e-7f);
        }
    }
}

void expect_same(const Object& a, const Scene& in_a, const Object& b, const Scene& in_b, bool named) {
    Material ma = in_a.materials.at(a.material), mb = in_b.materials.at(b.material);
    if (!named) ma.name = mb.name;
    EXPECT_EQ(ma, mb) << ma.name << " " << mb.name;
    const glm::dmat4 &ta = in_a.transforms.at(a.transform), &tb = in_b.transforms.at(b.transform);
    for (int c = 0; c < 4; ++c) EXPECT_LE(glm::distance(ta[c], tb[c]), 1e-13 * glm::length(ta[c]));
    EXPECT_EQ(a.crease, b.crease);
    EXPECT_EQ(a.subdivide, b.subdivide);
    ASSERT_EQ(a.shape.index(), b.shape.index());
    std::visit([&](const auto& shape) { expect_same(shape, std::get<std::decay_t<decltype(shape)>>(b.shape)); }, a.shape);
    if (const auto* use = std::get_if<MeshUse>(&a.shape))
        expect_same(in_a.meshes.at(use->mesh), in_b.meshes.at(std::get<MeshUse>(b.shape).mesh), 1);
}

void expect_same(const Scene& a, const Scene& b, bool named) {
    EXPECT_EQ(a.film, b.film);
    EXPECT_EQ(a.environment.background, b.environment.background);
    EXPECT_EQ(a.environment.ambient, b.environment.ambient);
    ASSERT_EQ(a.cameras.size(), b.cameras.size());
    for (std::size_t i = 0; i < a.cameras.size(); ++i) expect_same(a.cameras[i], b.cameras[i], named);
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (std::size_t i = 0; i < a.lights.size(); ++i) expect_same(a.lights[i], b.lights[i]);
    ASSERT_EQ(a.objects.size(), b.objects.size());
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        SCOPED_TRACE("object " + std::to_string(i));
        expect_same(a.objects[i], a, b.objects[i], b, named);
    }
}

// Nothing at its default, all numbers awkward.
Scene everything() {
    Scene scene;
    scene.film = glm::uvec2(321, 123);
    scene.environment = {{0.1f, 0.2f, 0.3f}, {0.7f, 0.07f, 0.007f}, {}};
    scene.cameras = {{"left \"eye\"", {0.1, 1.0 / 3, 5e-5}, {-7.1, 1e9, 2}, {0.3, 0.4, 0.5}, 1.2345678901234567, 0.015625},
                     {"b", {}, {1, 0, 0}, {0, 0, 1}, 3.1, 0}};
    const glm::dvec3 d = glm::normalize(glm::dvec3(0.3, -1, 0.2));
    scene.lights = {{LightType::point, {1.1, 2.2, 3.3}, {}, {0.1f, 2.7f, 1e-7f}, Attenuation::inverse_square, 1, 0.5, 0.1},
                    {LightType::spot, {1e-3, -2, 3}, d, {1, 1, 0.3f}, Attenuation::linear, 0.37, 0.7123456789, 0.3},
                    {LightType::directional, {}, -d, glm::vec3(1.0f / 3), Attenuation::none, 1, 0.5, 0.1}};
    Material m;
    m.name = "all";
    m.diffuse = {0.1f, 0.2f, 1.0f / 3}, m.specular = {0.9f, 0.8f, 0.7f}, m.shininess = 3.0827f;
    m.model = Model::cook_torrance, m.distribution = Distribution::beckmann, m.roughness = 0.123f, m.ior = {1.51f, 1.52f, 1.53f};
    m.f0 = glm::vec3(0.95f, 0.64f, 0.54f), m.fresnel = true, m.reflection = glm::vec3(0.25f), m.transmission = {0.5f, 0.6f, 0.7f};
    m.scatter = 0.05f, m.dispersion = {1.5f, 0.004f}, m.opacity = {0.2f, 0.4f, 1}, m.emission = {3, 2, 1}, m.two_sided = false,
    m.environment = 0.6f;
    m.texture = Texture{std::nullopt, Mapping::cylindrical, {4, 2.5}};
    m.bump = Bump{std::nullopt, false, BumpFunction::waves, 0.02, 7.5};
    scene.materials = {m};
    m.name = "other", m.two_sided = true, m.texture->mapping = Mapping::planar, m.bump->function = BumpFunction::noise;
    scene.materials.push_back(m);
    scene.transforms.push_back(world_from_object({{1.5, -2, 0.1}, {12.3, -45.6, 170.1}, {1.1, 2.2, -0.3}}));
    const auto add = [&](Shape shape) {
        Object& o = scene.objects.emplace_back();
        o.shape = std::move(shape);
        o.material = scene.objects.size() % 2, o.transform = 1, o.crease = 0.7123f, o.subdivide = 3;
    };
    add(Sphere{{0.1, 0.2, 0.3}, 1.0 / 7});
    add(Polygon{{{0, 0, 0}, {1.1, 0, 0}, {1.1, 0.7, 0}, {0.5, 0.2, 0}, {0, 0.7, 0}}, {}});
    add(Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                {glm::normalize(glm::vec3(1, 2, 3)), {0, 0, 1}, glm::normalize(glm::vec3(-1, 0.1f, 2))}});
    add(Box{{-1.1, -2.2, -3.3}, {0.1, 0.2, 0.3}});
    add(Cylinder{{0, 0.1, 0}, {1, 2, 3}, 0.05, false});
    add(Cone{{0, 0.1, 0}, {1, 2, 3}, 0.05, 0.7, false});
    add(Cone{{0, 0.1, 0}, {1, 2, 3}, 0.05, 0, true});
    add(Torus{{0.1, 0, 0}, d, 0.7, 0.9});
    return scene;
}

} // namespace

TEST_F(WriteRoundTrip, EveryFieldThroughToml) {
    expect_same(everything(), back(everything(), "all.toml"), true);
}

TEST_F(WriteRoundTrip, EveryKindThroughToml) {
    for (const MakeKind& kind : make_kinds()) {
        SCOPED_TRACE(kind.name);
        const MakeArguments few = kind.name == "mesh" ? MakeArguments{{"triangles", "20000"}} : MakeArguments{};
        const Scene scene = made(kind.name, few);
        expect_same(scene, back(scene, std::string(kind.name) + ".toml"), true);
    }
}

TEST_F(WriteRoundTrip, BallsAndSpheresThroughNff) {
    for (const char* kind : {"sphereflake", "spheres"}) {
        const Scene scene = made(kind);
        Scene read = back(scene, std::string(kind) + ".nff");
        // NFF knows no names, says kr = Ks outright, and fixes a size.
        for (Material& m : read.materials) m.reflection.reset();
        Scene meant = scene;
        if (!meant.film) meant.film = glm::uvec2(1280, 720);
        for (Material& m : meant.materials)
            if (m.specular == glm::vec3(0)) m.shininess = Material{}.shininess;
        expect_same(meant, read, false);
    }
}

TEST_F(WriteRoundTrip, MeshesThroughPlyAndObj) {
    const Scene scene = made("mesh", {{"triangles", "2000"}});
    for (const char* name : {"m.ply", "m.obj"}) {
        SCOPED_TRACE(name);
        const Scene read = back(scene, name);
        ASSERT_EQ(read.objects.size(), 1u);
        expect_same(scene.meshes.at(0), read.meshes.at(std::get<MeshUse>(read.objects[0].shape).mesh),
                    name == std::string("m.ply") ? 0 : 1);
    }
}
