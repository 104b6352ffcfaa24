// Which loader, which files: extensions, paths that leave the folder, things that are no files, and files placed in a native scene.
#include "scene/load.h"
#include "scene/paths.h"
#include "unit/load_fixtures.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace lightbench {
namespace {

using namespace testing_files;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(LoadScene, ChoosesByExtensionWhateverItsCase) {
    const Folder folder;
    EXPECT_TRUE(load_scene(folder.write("a.NFF", "s 0 0 0 1\n")).scene);
    EXPECT_TRUE(load_scene(folder.write("a.Toml", "")).scene);
    EXPECT_THAT(lines_of(load_scene(folder.write("a.xyz", "")), folder),
                ElementsAre("a.xyz: unknown extension \".xyz\"; a scene is one of .toml .nff .obj .gltf .glb .ply .stl"));
    EXPECT_THAT(lines_of(load_scene(folder.write("scene", "")), folder),
                ElementsAre("scene: the name has no extension; a scene is one of .toml .nff .obj .gltf .glb .ply .stl"));
}

TEST(LoadScene, OnlyRegularFiles) {
    const Folder folder;
    fs::create_directory(folder.path() / "dir.toml");
    ASSERT_EQ(::mkfifo((folder.path() / "pipe.nff").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", folder.path() / "zero.nff");
    fs::create_symlink("round.toml", folder.path() / "round.toml");
    EXPECT_THAT(lines_of(load_scene(folder.path() / "dir.toml"), folder),
                ElementsAre("dir.toml: it is a directory; it must be a regular file"));
    EXPECT_THAT(lines_of(load_scene(folder.path() / "pipe.nff"), folder), ElementsAre("pipe.nff: it is a pipe; it must be a regular file"));
    EXPECT_THAT(lines_of(load_scene(folder.path() / "zero.nff"), folder),
                ElementsAre("zero.nff: it is a device; it must be a regular file"));
    EXPECT_THAT(lines_of(load_scene(folder.path() / "round.toml"), folder), ElementsAre(HasSubstr("symbolic links")));
    EXPECT_THAT(lines_of(load_scene(folder.path() / "none.nff"), folder), ElementsAre("none.nff: there is no such file"));
}

TEST(Paths, NothingOutsideTheFolderUnlessAllowed) {
    const Folder folder;
    const fs::path inside = folder.path() / "scene";
    folder.write("secret.png", "x");
    folder.write("scene2/other.png", "x"); // a neighbour whose name begins alike
    folder.write("scene/in.png", "x");
    folder.write("scene/sub/deep.png", "x");
    fs::create_symlink("../secret.png", inside / "link.png");
    fs::create_symlink("in.png", inside / "near.png");
    fs::create_directory_symlink("..", inside / "up");
    for (const char* fine : {"in.png", "sub/deep.png", "sub/../in.png", "./in.png", "near.png"})
        EXPECT_EQ(resolve_file(inside, fine, false).why, "") << fine;
    for (const char* leaves : {"../secret.png", "/etc/passwd", "sub/../../secret.png", "link.png", "up/secret.png", "../scene2/other.png",
                               "../no-such-file.png", "..", "/no/such/file"})
        EXPECT_THAT(resolve_file(inside, leaves, false).why, HasSubstr("outside the scene's folder")) << leaves;
    for (const char* fine : {"../secret.png", "/etc/passwd", "link.png", "up/secret.png"})
        EXPECT_EQ(resolve_file(inside, fine, true).why, "") << fine;
    EXPECT_EQ(resolve_file(inside, "no.png", false).why, "there is no such file");
    EXPECT_EQ(resolve_file(inside, "sub", false).why, "it is a directory; it must be a regular file");
    EXPECT_THAT(resolve_file(inside, "", false).why, HasSubstr("empty"));
    EXPECT_THAT(resolve_file(inside, std::string_view("in.png\0.exe", 11), false).why, HasSubstr("NUL"));
    EXPECT_EQ(resolve_file(inside, "in.png", false).path, inside / "in.png");
}

TEST(Paths, TheFolderItselfMayBeASymbolicLinkOrTheCurrentOne) {
    const Folder folder;
    folder.write("real/in.png", "x");
    fs::create_directory_symlink("real", folder.path() / "alias");
    EXPECT_EQ(resolve_file(folder.path() / "alias", "in.png", false).why, "");
    EXPECT_EQ(folder_of("room.toml"), ".");
    EXPECT_EQ(folder_of("a/room.toml"), "a");
}

TEST(Paths, ReadsUpToTheLimitAndNoFurther) {
    const Folder folder;
    const fs::path file = folder.write("a.bin", std::string(1000, 'x'));
    EXPECT_EQ(read_file(file, 1000, "kLimit").text, std::string(1000, 'x'));
    EXPECT_EQ(read_file(file, 999, "kLimit").why, "the file is larger than 999 bytes (limit kLimit)");
    EXPECT_EQ(read_file(folder.write("empty", ""), 10, "kLimit").text, "");
    EXPECT_TRUE(read_file("/proc/self/status", 1 << 20, "kLimit").text); // says that it holds 0 bytes
    EXPECT_THAT(read_file("/proc/self/status", 10, "kLimit").why, HasSubstr("limit kLimit"));
}

// --- files as objects ---------------------------------------------------------------------------------------------------------------

constexpr const char* kBalls = "l 1 2 3\nv\nfrom 1 0 0\nat 0 0 0\nup 0 0 1\nangle 45\nresolution 8 8\n"
                               "f 1 0 0 1 0 0 0 0\ns 0 0 0 1\nf 0 1 0 1 0 0 0 0\ns 5 0 0 1\nc 0 0 0 1 0 0 1 1\n";

TEST(PlaceFile, ObjectsAreMergedWithTransformAndMaterials) {
    const Folder folder;
    folder.write("parts/balls.nff", kBalls);
    const auto file = folder.write("room.toml", R"(
[[material]]
name = "gold"
[[object]]
shape = "mesh"
file = "parts/balls.nff"
[[object]]
shape = "mesh"
file = "parts/balls.nff"
material = "gold"
translate = [0, 0, 7]
scale = 2
crease = 90
subdivide = 3
)");
    const Scene s = scene_of(load_scene(file));
    ASSERT_EQ(s.objects.size(), 6u);
    ASSERT_EQ(s.materials.size(), 3u); // read once
    EXPECT_EQ(s.materials[s.objects[0].material].diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(s.materials[s.objects[1].material].diffuse, glm::vec3(0, 1, 0));
    EXPECT_EQ(s.objects[0].transform, 0u);
    EXPECT_EQ(s.objects[0].subdivide, 0);
    for (std::size_t i = 3; i < 6; ++i) {
        EXPECT_EQ(s.materials[s.objects[i].material].name, "gold");
        EXPECT_EQ(s.transforms[s.objects[i].transform] * glm::dvec4(1, 1, 1, 1), glm::dvec4(2, 2, 9, 1));
        EXPECT_EQ(s.objects[i].subdivide, 3);
        EXPECT_FLOAT_EQ(s.objects[i].crease, 1.5707964f);
    }
    EXPECT_TRUE(s.lights.empty());
    EXPECT_TRUE(s.cameras.empty());
    EXPECT_THAT(s.remarks, ElementsAre("balls.nff: its 1 lights are left out; a placed file gives objects only",
                                       "balls.nff: its 1 cameras are left out; a placed file gives objects only"));
}

TEST(PlaceFile, ProblemsOfThePlacedFileCarryItsOwnName) {
    const Folder folder;
    folder.write("balls.nff", "s 0 0 0 0\n");
    const auto file = folder.write(
        "room.toml",
        "object = [{shape = \"mesh\", file = \"balls.nff\"}, {shape = \"mesh\", file = \"balls.nff\"}, {shape = \"box\", x = 1}]\n");
    EXPECT_THAT(lines_of(load_scene(file), folder), ElementsAre("balls.nff:1:9: s: radius is 0; it must be greater than 0",
                                                                HasSubstr("room.toml:1:103: object: unknown key \"x\"")));
}

TEST(PlaceFile, OnlyFormatsThatHoldGeometry) {
    const Folder folder;
    folder.write("other.toml", "");
    folder.write("note.txt", "");
    const auto file =
        folder.write("room.toml", "object = [{shape = \"mesh\", file = \"other.toml\"}, {shape = \"mesh\", file = \"note.txt\"},\n"
                                  "{shape = \"mesh\", file = \"../room.obj\"}]\n");
    EXPECT_THAT(
        lines_of(load_scene(file), folder),
        ElementsAre("room.toml:1:35: object: \"other.toml\": this format cannot be placed; it must be .nff .obj .gltf .glb .ply or .stl",
                    HasSubstr("room.toml:1:74: object: \"note.txt\": this format"),
                    "room.toml:2:25: object: file \"../room.obj\": it lies outside the scene's folder; move it into the folder or give "
                    "--allow-outside"));
}

TEST(PlaceFile, TheNumberOfFilesAndObjectsIsLimited) {
    const Folder folder;
    std::string text;
    for (int i = 0; i < 65; ++i) {
        folder.write(fmt::format("{}.nff", i), "s 0 0 0 1\n");
        text += fmt::format("[[object]]\nshape = \"mesh\"\nfile = \"{}.nff\"\n", i);
    }
    EXPECT_THAT(lines_of(load_scene(folder.write("many.toml", text)), folder),
                ElementsAre("many.toml:195:8: object: a scene places at most 64 files (limit kMaxIncludes)"));
    std::string big;
    for (int i = 0; i < 70000; ++i) big += "s 0 0 0 1\n";
    folder.write("big.nff", big);
    std::string copies;
    for (int i = 0; i < 60; ++i) copies += "[[object]]\nshape = \"mesh\"\nfile = \"big.nff\"\n";
    EXPECT_THAT(lines_of(load_scene(folder.write("copies.toml", copies)), folder),
                ElementsAre("copies.toml:180:8: object: more than 4194304 objects (limit kMaxObjects)"));
}

TEST(PlaceFile, AMeshObeysTheObjectsMaterial) {
    const Folder folder;
    folder.write("two.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n");
    folder.write("two.obj", "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl green\nf 1 3 4\n");
    const auto file = folder.write("room.toml", "material = [{name = \"gold\"}]\nobject = [{shape = \"mesh\", file = \"two.obj\"}, "
                                                "{shape = \"mesh\", file = \"two.obj\", material = \"gold\"}]\n");
    const Scene s = scene_of(load_scene(file));
    std::vector<std::string> own, replaced;
    for (std::size_t i = 0; i < s.objects.size(); ++i) {
        const auto* use = std::get_if<MeshUse>(&s.objects[i].shape);
        ASSERT_TRUE(use);
        const Mesh& mesh = s.meshes.at(use->mesh);
        auto& names = i < s.objects.size() / 2 ? own : replaced;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            names.push_back(s.materials.at(mesh.face_materials.empty() ? s.objects[i].material : mesh.face_materials[f]).name);
    }
    EXPECT_THAT(own, testing::UnorderedElementsAre("red", "green"));
    EXPECT_THAT(replaced, ElementsAre("gold", "gold"));
}

} // namespace
} // namespace lightbench
