// OBJ and MTL: polygons, shared vertices, materials, and the problems that Assimp would not tell.
#include "unit/import_support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace lightbench {
namespace {

using namespace importer_test;
using testing::ElementsAre;
using testing::HasSubstr;

// A quad and a triangle that share an edge, each with its material.
constexpr std::string_view kTwoFaces = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\n"
                                       "usemtl red\nf 1 2 3 4\nusemtl blue\nf 2 5 3\n";
constexpr std::string_view kTwoMaterials = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\nnewmtl unused\nKd 0 1 0\n";

Loaded import_with(const std::string& obj, const std::string& mtl) {
    const Folder folder;
    folder.write("m.mtl", mtl);
    return import_file(folder.write("a.obj", obj));
}

Material material_of(const std::string& mtl) {
    const Loaded loaded = import_with("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n", "newmtl a\n" + mtl);
    EXPECT_TRUE(loaded.scene) << all_problems(loaded);
    return loaded.scene ? loaded.scene->materials.at(loaded.scene->objects.at(0).material) : Material{};
}

TEST(ImportObj, KeepsPolygonsAndSharesVerticesAcrossMaterials) {
    const Loaded loaded = import_with(std::string(kTwoFaces), std::string(kTwoMaterials));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->meshes.size(), 1u);
    const Mesh& mesh = loaded.scene->meshes[0];
    EXPECT_EQ(mesh.positions.size(), 5u);
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(mesh.uvs.empty());
    EXPECT_THAT(mesh.face_starts, ElementsAre(0, 4, 7));
    EXPECT_THAT(corners(mesh, 0), ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(corners(mesh, 1), ElementsAre(glm::vec3(1, 0, 0), glm::vec3(2, 0, 1), glm::vec3(1, 1, 0)));
    ASSERT_EQ(mesh.face_materials.size(), 2u);
    EXPECT_EQ(loaded.scene->materials.at(mesh.face_materials[0]).diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(loaded.scene->materials.at(mesh.face_materials[1]).diffuse, glm::vec3(0, 0, 1));
    EXPECT_EQ(loaded.scene->materials.size(), 2u) << "materials that no face uses call for nothing";
    EXPECT_TRUE(loaded.scene->lights.empty());
    EXPECT_TRUE(loaded.scene->cameras.empty());
    EXPECT_EQ(all_remarks(loaded), "");
}

TEST(ImportObj, KeepsNormalsAndCoordinatesOfTheFile) {
    const Loaded loaded = import_text("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 3 0 4\nvt 0.25 0.75\nvt 1 0\n"
                                               "f 1/1/1 2/2/1 3/1/2\n");
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    const Mesh& mesh = loaded.scene->meshes.at(0);
    ASSERT_EQ(mesh.normals.size(), 3u);
    EXPECT_EQ(mesh.normals[mesh.corners[0]], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[mesh.corners[2]], glm::vec3(0.6f, 0, 0.8f));
    EXPECT_EQ(mesh.uvs[mesh.corners[0]], glm::vec2(0.25f, 0.75f));
    EXPECT_EQ(mesh.uvs[mesh.corners[1]], glm::vec2(1, 0));
}

TEST(ImportObj, SplitsFacesWithoutUsableNormalsOff) {
    const Loaded loaded =
        import_text("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 0 0 0\nf 1//1 2//1 3//1\nf 2//1 4//2 3//1\nf 3 2 1\n");
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->meshes.size(), 2u);
    EXPECT_EQ(loaded.scene->meshes[0].face_count(), 1u);
    EXPECT_EQ(loaded.scene->meshes[0].normals.size(), 3u);
    EXPECT_EQ(loaded.scene->meshes[1].face_count(), 2u);
    EXPECT_TRUE(loaded.scene->meshes[1].normals.empty());
    EXPECT_THAT(all_remarks(loaded), HasSubstr("without direction"));
}

TEST(ImportObj, ReadsWhatRealFilesHold) {
    const Loaded loaded =
        import_text("a.OBJ", "\xEF\xBB\xBF# bom, C:\\\r\ng one\r\n  v 0 0 0\r\nv +1e0 0 0 1.0\r\n\tv 0 \\\r\n 1 0\r\nf -3 -2 "
                             "\\\r\n-1\r\no two\r\ns off\r\nf 1/ 3// 4\r\nv 5 5 5\r\n"
                             "parm u 0 1\r\npoint 1 2 3\r\np 1 2\r\nl 1 2 3\r\nf 1 2 # two\r\n");
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    const Mesh& mesh = loaded.scene->meshes.at(0);
    ASSERT_EQ(mesh.face_count(), 2u);
    EXPECT_THAT(corners(mesh, 0), ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(corners(mesh, 1), ElementsAre(glm::vec3(0, 0, 0), glm::vec3(0, 1, 0), glm::vec3(5, 5, 5)))
        << "a face may use vertices that follow it";
    const std::string remarks = all_remarks(loaded);
    EXPECT_THAT(remarks, HasSubstr("1 lines of points are not drawn"));
    EXPECT_THAT(remarks, HasSubstr("1 lines of line segments are not drawn"));
    EXPECT_THAT(remarks, HasSubstr("1 lines of free-form curves and surfaces are not drawn"));
    EXPECT_THAT(remarks, HasSubstr("first \"point\" in line 14"));
}

TEST(ImportObj, ReadsOldMacLineEnds) {
    const Loaded loaded = import_text("a.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r");
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    EXPECT_EQ(loaded.scene->meshes.at(0).face_count(), 1u);
}

struct BadObj {
    std::string_view content, problem;
};

class ImportObjProblem : public testing::TestWithParam<BadObj> {};

TEST_P(ImportObjProblem, NamesTheLine) {
    const Loaded loaded = import_text("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + std::string(GetParam().content) + "f 1 2 3\n");
    EXPECT_FALSE(loaded.scene);
    EXPECT_THAT(all_problems(loaded), HasSubstr("bad.obj" + std::string(GetParam().problem)));
}

INSTANTIATE_TEST_SUITE_P(
    All, ImportObjProblem,
    testing::Values(BadObj{"\nf\n", ":5: f is empty"}, BadObj{"f 1 2 4\n", ":4: vertex 4 does not exist; the file has 3"},
                    BadObj{"f 0 1 2\n", ":4: vertex 0 does not exist"}, BadObj{"f 1 2 -4\n", ":4: vertex -4 does not exist"},
                    BadObj{"f 1/1 2/1 3/1\n", ":4: texture coordinate 1 does not exist; the file has 0"},
                    BadObj{"f 1//1 2//1 3//1\n", ":4: normal 1 does not exist"},
                    BadObj{"vn 0 0 1\nf 1//1 2//1 3\n", ":5: f: its corners differ"}, BadObj{"f 1/2/3/4 1 2\n", ":4: \"1/2/3/4\" has more"},
                    BadObj{"f a b c\n", ":4: \"a\" is not a vertex number"},
                    BadObj{"f 1 2 99999999999999999999\n", ":4: \"99999999999999999999\" is not a vertex number"},
                    BadObj{"v 1 2\n", ":4: v has 2 numbers"}, BadObj{"v 1 2 nan\n", ":4: v: \"nan\" is not finite"},
                    BadObj{"v 1 2 1e999\n", ":4: v: \"1e999\" is not finite"}, BadObj{"v 1 2 0x3\n", ":4: v: \"0x3\" is not a number"},
                    BadObj{"v 1,5 2 3\n", ":4: v: \"1,5\" is not a number"}, BadObj{"v 1 2 3 0\n", ":4: v: the weight is 0"},
                    BadObj{"v 1 2 1e16\nf 1 2 4\n", ": a vertex lies at 1e+16"}));

TEST(ImportObj, ReportsEveryProblemInOrder) {
    const Loaded loaded = import_text("bad.obj", "v 0 0 0\nv 1 0 x\nv 0 1 0\nf 1 2 9\nf\nf 1 2 0\n");
    ASSERT_EQ(loaded.problems.size(), 4u) << all_problems(loaded);
    for (unsigned i = 0; i < 4; ++i) EXPECT_EQ(loaded.problems[i].line, (std::array{2u, 4u, 5u, 6u})[i]);
}

TEST(ImportObj, ListsNoMoreProblemsThanAsked) {
    std::string text = "v 0 0 0\n";
    for (int i = 0; i < 50; ++i) text += "f\n";
    const Folder folder;
    LoadOptions options;
    options.max_problems = 10;
    const Loaded loaded = import_file(folder.write("a.obj", text), options);
    EXPECT_EQ(loaded.problems.size(), 11u);
    EXPECT_EQ(loaded.unlisted, 40u);
}

TEST(ImportObj, DrawsUndefinedMaterialsWithTheDefaultOne) {
    const Loaded loaded = import_text("a.obj", "mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl lost\nf 1 2 3\n");
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    EXPECT_EQ(loaded.scene->materials.at(loaded.scene->objects.at(0).material), Material{});
    EXPECT_THAT(all_remarks(loaded), HasSubstr("line 1: the material library \"gone.mtl\" does not exist"));
    EXPECT_THAT(all_remarks(loaded), HasSubstr("first \"lost\" in line 5"));
}

TEST(ImportMtl, ReadsColorsAndNumbers) {
    const Material m = material_of("Ka 0.1 0.2 0.3\nKd 0.1 0.2 0.3\nKs 0.5\nKe 2 3 4\nNs 100000\nNi 1.33\nd 0.25\nillum 2\n");
    EXPECT_EQ(m.name, "a");
    EXPECT_EQ(m.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.specular, glm::vec3(0.5f));
    EXPECT_EQ(m.emission, glm::vec3(2, 3, 4));
    EXPECT_EQ(m.shininess, 100000.0f);
    EXPECT_EQ(m.ior, glm::vec3(1.33f));
    EXPECT_EQ(m.opacity, glm::vec3(0.25f));
    EXPECT_EQ(m.reflection, glm::vec3(0)) << "illum 2 has highlights, no mirror";
    EXPECT_EQ(m.transmission, glm::vec3(0));
    EXPECT_FALSE(m.two_sided.has_value());
}

TEST(ImportMtl, FollowsIllum) {
    EXPECT_EQ(material_of("Ks 1 1 1\nillum 1\n").specular, glm::vec3(0));
    EXPECT_EQ(material_of("Ks 1 1 1\n").specular, glm::vec3(1));
    EXPECT_EQ(material_of("Ks 1 1 1\n").reflection, glm::vec3(0));
    EXPECT_FALSE(material_of("Ks 1 1 1\nillum 3\n").reflection.has_value()) << "absent: Ks";
    EXPECT_EQ(material_of("Tf 0.5 0.6 0.7\nillum 2\n").transmission, glm::vec3(0));
    EXPECT_EQ(material_of("Tf 0.5 0.6 0.7\nillum 6\n").transmission, glm::vec3(0.5f, 0.6f, 0.7f));
    EXPECT_FALSE(material_of("illum 6\n").fresnel);
    EXPECT_TRUE(material_of("illum 7\n").fresnel);
    EXPECT_EQ(material_of("Tr 0.25\n").opacity, glm::vec3(0.75f));
}

// The table of obj_material.h, row by row.
TEST(ImportMtl, NamesTheEffectsOfEveryIllum) {
    struct {
        int illum;
        bool highlight, reflection, transmission, fresnel, filtered;
    } const rows[] = {
        {0, false, false, false, false, false}, {1, false, false, false, false, false}, {2, true, false, false, false, false},
        {3, true, true, false, false, false},   {4, true, true, false, false, true},    {5, true, true, false, true, false},
        {6, true, true, true, false, false},    {7, true, true, true, true, false},     {8, true, true, false, false, false},
        {9, true, true, false, false, true},    {10, true, false, false, false, false},
    };
    for (const auto& row : rows) {
        const Material m = material_of(fmt::format("Kd 0.5\nKs 0.25\nd 0.5\nTf 1 0.5 0\nillum {}\n", row.illum));
        EXPECT_EQ(m.specular, glm::vec3(row.highlight ? 0.25f : 0.0f)) << row.illum;
        EXPECT_EQ(m.reflection.value_or(m.specular), glm::vec3(row.reflection ? 0.25f : 0.0f)) << row.illum;
        EXPECT_EQ(m.transmission, row.transmission ? glm::vec3(1, 0.5f, 0) : glm::vec3(0)) << row.illum;
        EXPECT_EQ(m.fresnel, row.fresnel) << row.illum;
        EXPECT_EQ(m.opacity, row.filtered ? glm::vec3(0.5f, 0.75f, 1) : glm::vec3(0.5f)) << row.illum;
        EXPECT_EQ(m.diffuse, glm::vec3(0.5f)) << row.illum;
    }
    EXPECT_EQ(material_of("Tf 1 1 1\nillum 4\n").opacity, glm::vec3(1)) << "writers put Tf into opaque materials";
    EXPECT_EQ(material_of("Tf 0 0 0\nd 0.5\nillum 9\n").opacity, glm::vec3(0.5f));
    EXPECT_THAT(all_remarks(import_with("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n", "newmtl a\nillum 0\n")),
                HasSubstr("illum 0 (color without light) is drawn lit"));
}

TEST(ImportMtl, RemarksWhatItDoesNotUse) {
    const std::string obj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    EXPECT_THAT(all_remarks(import_with(obj, "newmtl a\nKa 1 0 0\nKd 0 1 0\n")), HasSubstr("Ka is not used"));
    EXPECT_THAT(all_remarks(import_with(obj, "newmtl a\nKd 1.5 0 0\n")), HasSubstr("m.mtl:2: Kd lies outside 0 to 1"));
    EXPECT_THAT(all_remarks(import_with(obj, "newmtl a\nPr 0.5\nmap_Ks x.png\n")), HasSubstr("not used: Pr, map_Ks"));
    EXPECT_THAT(all_remarks(import_with(obj, "newmtl a\nmap_Kd gone.png\n")), HasSubstr("\"gone.png\" does not exist"));
    EXPECT_EQ(all_remarks(import_with(obj, "newmtl a\nKa 0 1 0\nKd 0 1 0\n")), "");
}

TEST(ImportMtl, NamesTheLineOfProblems) {
    const Loaded loaded = import_with("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n",
                                      "Kd 1 1 1\nnewmtl a\nKd 1 x 0\nNs -1\nNi\nd inf\nmap_Kd\n");
    EXPECT_FALSE(loaded.scene);
    const std::string problems = all_problems(loaded);
    for (const char* expected : {"m.mtl:1: \"Kd\" before the first newmtl", "m.mtl:3: Kd: \"x\" is not", "m.mtl:4: Ns is -1",
                                 "m.mtl:5: Ni has no value", "m.mtl:6: d: \"inf\"", "m.mtl:7: map_Kd names no file"})
        EXPECT_THAT(problems, HasSubstr(expected));
}

TEST(ImportMtl, ReferencesPicturesWithoutReadingThem) {
    const Folder folder;
    folder.write("tex/wood grain.png", "not decoded here");
    folder.write("m.mtl", "newmtl a\nmap_Kd -clamp on -s 2 3 1 tex\\wood grain.png\nmap_bump -bm 0.5 tex/wood grain.png\n");
    const Loaded loaded = import_file(folder.write("a.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->pictures.size(), 1u);
    EXPECT_EQ(std::filesystem::canonical(loaded.scene->pictures[0].file), std::filesystem::canonical(folder.path / "tex/wood grain.png"));
    const Material& m = loaded.scene->materials.at(0);
    ASSERT_TRUE(m.texture && m.bump);
    EXPECT_EQ(m.texture->picture, 0u);
    EXPECT_EQ(m.texture->scale, glm::dvec2(2, 3));
    EXPECT_EQ(m.texture->wrap_u, Wrap::clamp);
    EXPECT_EQ(m.texture->wrap_v, Wrap::clamp);
    EXPECT_EQ(all_remarks(loaded), "");
    EXPECT_EQ(m.bump->amplitude, 0.5 * Bump{}.amplitude);
    EXPECT_FALSE(m.bump->normal_map);
}

TEST(ImportMtl, StaysInsideTheFolder) {
    const Folder folder;
    folder.write("secret.mtl", "newmtl a\nKd 1 0 0\n");
    folder.write("secret.png", "x");
    const std::string rest = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    const auto up = folder.write("in/up.obj", "mtllib ../secret.mtl\n" + rest);
    std::filesystem::create_symlink(folder.path / "secret.mtl", folder.path / "in/link.mtl");
    const auto link = folder.write("in/link.obj", "mtllib link.mtl\n" + rest);
    folder.write("in/picture.mtl", "newmtl a\nmap_Kd ../secret.png\n");
    const auto picture = folder.write("in/picture.obj", "mtllib picture.mtl\n" + rest);
    LoadOptions allow;
    allow.allow_outside = true;
    for (const auto& file : {up, link, picture}) {
        EXPECT_THAT(all_problems(import_file(file)), HasSubstr("outside the scene's folder")) << file;
        EXPECT_TRUE(import_file(file, allow).scene) << file;
        EXPECT_TRUE(import_file(file, {}, folder.path).scene) << "the scene that places it may own more: " << file;
    }
    folder.write("in/absolute.mtl", "newmtl a\nmap_Kd /home/author/wood.png\n");
    const Loaded absolute = import_file(folder.write("in/absolute.obj", "mtllib absolute.mtl\n" + rest));
    EXPECT_TRUE(absolute.scene) << all_problems(absolute);
    EXPECT_THAT(all_remarks(absolute), HasSubstr("\"/home/author/wood.png\" is not read"));
}

} // namespace
} // namespace lightbench
