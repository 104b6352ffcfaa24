// Scenes as files: the bytes that are written, what a format cannot hold, and files that appear whole or not at all.
#include "scene/make.h"
#include "scene/write.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>
#include <system_error>
#include <unistd.h>

using namespace lightbench;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace {

struct WriteFormats : testing::Test {
    std::filesystem::path folder = std::filesystem::temp_directory_path() / ("lightbench-write-" + std::to_string(getpid()));
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    std::string text(const char* name) const {
        std::ifstream in(folder / name, std::ios::binary);
        return (std::ostringstream() << in.rdbuf()).str();
    }
    std::vector<std::string> complaints(const Scene& scene, const char* name) const {
        std::vector<std::string> texts;
        for (const Problem& p : write_scene(scene, folder / name)) texts.push_back(p.text);
        return texts;
    }
    std::size_t files() const { return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {})); }
};

Scene made(std::string_view kind, const MakeArguments& arguments = {}) {
    return std::get<Scene>(make_scene(kind, arguments));
}

Material named(std::string name) {
    Material m;
    m.name = std::move(name);
    return m;
}

void add(Scene& scene, Shape shape, std::uint32_t material = 0) {
    scene.objects.emplace_back().shape = std::move(shape);
    scene.objects.back().material = material;
}

Scene one(Shape shape) {
    Scene scene;
    scene.materials.push_back(named("m"));
    add(scene, std::move(shape));
    return scene;
}

std::size_t count(std::string_view text, std::string_view what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++n;
    return n;
}

} // namespace

TEST_F(WriteFormats, TomlHoldsWhatDiffersFromTheDefaults) {
    Scene scene = one(Sphere{{1, 2, 3}, 0.5});
    scene.lights.push_back({});
    EXPECT_THAT(write_scene(scene, folder / "a.toml", "first line\nsecond"), IsEmpty());
    EXPECT_EQ(text("a.toml"),
              "# first line\n# second\n\n[[light]]\ntype = \"point\"\nposition = [0, 0, 0]\n\n[[material]]\nname = \"m\"\n\n"
              "[[object]]\nshape = \"sphere\"\ncenter = [1, 2, 3]\nradius = 0.5\nmaterial = \"m\"\n");
}

TEST_F(WriteFormats, TomlNamesMaterialsApart) {
    Scene scene = one(Sphere{});
    scene.materials = {named("a\"b\n"), named(""), named("x"), named("x"), named("material-2")};
    for (std::uint32_t i = 1; i < 5; ++i) add(scene, Sphere{}, i);
    EXPECT_THAT(write_scene(scene, folder / "a.toml"), IsEmpty());
    const std::string all = text("a.toml");
    for (const char* name :
         {"name = \"a\\\"b\\u000A\"", "name = \"material-3\"", "name = \"x\"", "name = \"material-4\"", "name = \"material-2\""})
        EXPECT_EQ(count(all, std::string(name) + "\n"), 1u) << name << "\n" << all;
    EXPECT_EQ(count(all, "\nname = "), 5u);
}

TEST_F(WriteFormats, TomlPutsMeshesBeside) {
    EXPECT_THAT(write_scene(made("crease"), folder / "two words.toml"), IsEmpty());
    EXPECT_EQ(files(), 5u);
    EXPECT_THAT(text("two words.toml"), HasSubstr("file = \"two words-cube-left.obj\"\nmaterial = \"clay\"\ncrease = 180\n"));
    EXPECT_EQ(count(text("two words-prism-right.obj"), "\nv "), 48u);
    EXPECT_EQ(count(text("two words-prism-right.obj"), "\nf "), 26u);
}

TEST_F(WriteFormats, NffIsHaines) {
    EXPECT_THAT(write_scene(made("sphereflake", {{"depth", "1"}}), folder / "balls.nff"), IsEmpty());
    const std::string all = text("balls.nff");
    EXPECT_THAT(
        all,
        StartsWith(
            "b 0.078 0.361 0.753\nv\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.01\nresolution 512 512\nl 4 3 2 0.57735026"));
    EXPECT_THAT(all, HasSubstr("\nf 0.5 0.45 0.35 1 0.5 3.0827 0 0\ns 0 0 0 0.5\n"));
    EXPECT_EQ(count(all, "\ns "), 10u);
    EXPECT_EQ(count(all, "\nf "), 2u);
    EXPECT_THAT(all, HasSubstr("\np 4\n12 12 -0.5\n"));
}

TEST_F(WriteFormats, TomlRefusesWhatItCannotSay) {
    Scene scene = one(MeshUse{0});
    scene.meshes = {{"rug", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 0}, {1, 0}, {0, 1}}, {}, {0, 1, 2}, {0, 3}, {}}};
    EXPECT_THAT(complaints(scene, "a.toml"), IsEmpty());
    scene.meshes[0].tangents.assign(3, {1, 0, 0, 1});
    EXPECT_THAT(complaints(scene, "a.toml"), ElementsAre(HasSubstr("mesh \"rug\": a mesh with tangents cannot be written")));
    scene = one(Sphere{});
    scene.materials[0].texture = Texture{};
    EXPECT_THAT(complaints(scene, "a.toml"), IsEmpty());
    scene.materials[0].texture->wrap_v = Wrap::mirror;
    EXPECT_THAT(complaints(scene, "a.toml"), ElementsAre(HasSubstr("material \"m\": a texture that clamps or mirrors")));
}

TEST_F(WriteFormats, NffRefusesWhatItCannotSay) {
    EXPECT_THAT(complaints(one(Box{}), "a.nff"), ElementsAre("object 1: a box cannot be written; NFF has none; write .toml"));
    EXPECT_THAT(complaints(one(Torus{}), "a.nff"), ElementsAre(HasSubstr("a torus")));
    EXPECT_THAT(complaints(one(Cylinder{}), "a.nff"), ElementsAre(HasSubstr("a capped cylinder")));
    EXPECT_THAT(complaints(one(Cylinder{{0, 0, 0}, {0, 1, 0}, 1, false}), "a.nff"), IsEmpty());
    EXPECT_THAT(complaints(made("corrugated"), "a.nff"), testing::Contains(HasSubstr("a mesh")));
    const auto all = complaints(made("primitives"), "b.nff");
    EXPECT_THAT(all, testing::Contains("light 1 and 1 more: attenuation cannot be written; NFF's lights have none; write .toml"));
    EXPECT_THAT(all, testing::Contains(HasSubstr("ambient light")));
    Scene scene = one(Sphere{});
    scene.materials[0].opacity = glm::vec3(0.5f);
    EXPECT_THAT(complaints(scene, "a.nff"), ElementsAre(HasSubstr("material \"m\"")));
    scene = one(Sphere{});
    add(scene, Box{});
    add(scene, Box{});
    EXPECT_THAT(complaints(scene, "c.nff"), ElementsAre(StartsWith("object 2 and 1 more: a box")));
    EXPECT_EQ(std::filesystem::exists(folder / "b.nff") || std::filesystem::exists(folder / "c.nff"), false);
}

TEST_F(WriteFormats, PlyHoldsEveryNumber) {
    const Scene scene = made("mesh", {{"triangles", "48"}});
    EXPECT_THAT(write_scene(scene, folder / "m.ply"), IsEmpty());
    const std::string all = text("m.ply"), end = "end_header\n";
    EXPECT_THAT(all,
                StartsWith("ply\nformat binary_little_endian 1.0\nelement vertex 26\nproperty float x\nproperty float y\nproperty float z\n"
                           "element face 48\nproperty list uchar uint vertex_indices\nend_header\n"));
    const char* at = all.data() + all.find(end) + end.size();
    ASSERT_EQ(all.data() + all.size() - at, 26 * 12 + 48 * 13);
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(std::memcmp(at, mesh.positions.data(), 26 * 12), 0);
    for (std::size_t f = 0; f < 48; ++f) {
        const char* face = at + 26 * 12 + 13 * f;
        EXPECT_EQ(face[0], 3);
        EXPECT_EQ(std::memcmp(face + 1, &mesh.corners[3 * f], 12), 0) << f;
    }
}

TEST_F(WriteFormats, ShapeFormatsMergePolygonsInWorldSpace) {
    EXPECT_THAT(complaints(made("primitives"), "p.obj"), ElementsAre(HasSubstr("a curved primitive or a box")));
    EXPECT_THAT(complaints(made("cornell-box"), "c.obj"), IsEmpty());
    EXPECT_EQ(count(text("c.obj"), "\nf "), 17u);
    Scene scene = one(Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}});
    scene.transforms.push_back(glm::dmat4(2));
    scene.transforms[1][3] = {5, 0, 0, 1};
    scene.objects[0].transform = 1;
    EXPECT_THAT(complaints(scene, "t.obj"), IsEmpty());
    EXPECT_EQ(text("t.obj"), "v 5 0 0\nv 7 0 0\nv 5 2 0\nf 1 2 3\n");
    scene.transforms[1][0].x = -2;
    EXPECT_THAT(complaints(scene, "t.obj"), ElementsAre(HasSubstr("mirroring")));
}

TEST_F(WriteFormats, UnknownExtensions) {
    for (const char* name : {"a.xyz", "a", ".toml", "a.toml~"})
        EXPECT_THAT(complaints(one(Sphere{}), name), ElementsAre(HasSubstr("must be .toml, .nff"))) << name;
    EXPECT_THAT(complaints(one(Sphere{}), "a.TOML"), IsEmpty());
    EXPECT_EQ(files(), 1u);
}

TEST_F(WriteFormats, FailuresOfTheDiskLeaveNothingBehind) {
    EXPECT_THROW(write_scene(one(Sphere{}), folder / "none" / "a.toml"), std::system_error);
    std::filesystem::create_directories(folder / "taken.toml" / "full");
    EXPECT_THROW(write_scene(one(Sphere{}), folder / "taken.toml"), std::system_error);
    EXPECT_EQ(files(), 1u);
    if (std::filesystem::exists("/dev/full")) {
        std::filesystem::create_symlink("/dev/full", folder / ("x.nff." + std::to_string(getpid()) + ".part"));
        EXPECT_THROW(write_scene(one(Sphere{}), folder / "x.nff"), std::system_error);
        EXPECT_FALSE(std::filesystem::exists(folder / "x.nff"));
    }
}

TEST_F(WriteFormats, TheSameSceneGivesTheSameBytes) {
    for (const MakeKind& kind : make_kinds()) {
        const MakeArguments small = kind.name == "mesh" ? MakeArguments{{"triangles", "1200"}} : MakeArguments{};
        const std::string name = std::string(kind.name) + ".toml", again = std::string(kind.name) + "-again.toml";
        ASSERT_THAT(write_scene(made(kind.name, small), folder / name), IsEmpty()) << kind.name;
        const std::string first = text(name.c_str());
        ASSERT_THAT(write_scene(made(kind.name, small), folder / name), IsEmpty());
        EXPECT_EQ(first, text(name.c_str())) << kind.name;
    }
}
