// Files that nobody here wrote: Debian's assimp-testmodels and glmark2-data. Each loads with the counts that its own text states, or is
// refused for the reason that can be seen in it.
#include "unit/import_support.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using namespace importer_test;
using testing::HasSubstr;

const std::filesystem::path kModels = "/usr/share/assimp/models";

// Counted with grep in the files: `f` lines of OBJ, `element face` of PLY, facets of STL, indices / 3 of glTF.
struct Model {
    const char* name;
    std::size_t faces, lights, cameras;
};

class ImportModel : public testing::TestWithParam<Model> {};

TEST_P(ImportModel, Loads) {
    const auto file = kModels / GetParam().name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "assimp-testmodels is not installed";
    const Loaded loaded = import_file(file);
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    std::size_t faces = 0;
    for (const Mesh& mesh : loaded.scene->meshes) faces += mesh.face_count();
    EXPECT_EQ(faces, GetParam().faces);
    EXPECT_EQ(loaded.scene->lights.size(), GetParam().lights);
    EXPECT_EQ(loaded.scene->cameras.size(), GetParam().cameras);
}

INSTANTIATE_TEST_SUITE_P(
    All, ImportModel,
    testing::Values(Model{"OBJ/box.obj", 6, 0, 0}, Model{"OBJ/box_longline.obj", 6, 0, 0}, Model{"OBJ/box_mat_with_spaces.obj", 6, 0, 0},
                    Model{"OBJ/box_without_lineending.obj", 6, 0, 0}, Model{"OBJ/concave_polygon.obj", 1, 0, 0},
                    Model{"OBJ/cube_usemtl.obj", 12, 0, 0}, Model{"OBJ/cube_with_vertexcolors.obj", 12, 0, 0},
                    Model{"OBJ/multiple_spaces.obj", 1, 0, 0}, Model{"OBJ/spider.obj", 1368, 0, 0}, Model{"OBJ/testmixed.obj", 6, 0, 0},
                    Model{"PLY/cube.ply", 6, 0, 0}, Model{"PLY/cube_binary.ply", 12, 0, 0}, Model{"PLY/Wuson.ply", 3732, 0, 0},
                    Model{"STL/Spider_ascii.stl", 1368, 0, 0}, Model{"STL/Spider_binary.stl", 1368, 0, 0},
                    Model{"STL/triangle_with_two_solids.stl", 2, 0, 0}, Model{"STL/3DSMaxExport.STL", 2000, 0, 0},
                    Model{"glTF2/BoxTextured-glTF/BoxTextured.gltf", 12, 0, 0},
                    Model{"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", 12, 0, 0}, Model{"glTF2/cameras/Cameras.gltf", 2, 0, 1},
                    Model{"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_05.gltf", 2, 0, 0},
                    Model{"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_13.gltf", 2, 0, 0},
                    Model{"glTF2/simple_skin/simple_skin.gltf", 8, 0, 0}));

struct Refusal {
    const char *name, *reason;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { // else the tests would be named by addresses
    *out << refusal.name << refusal.reason;
}

class ImportRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(ImportRefusal, SaysWhy) {
    const auto file = kModels / GetParam().name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "assimp-testmodels is not installed";
    const Loaded loaded = import_file(file);
    EXPECT_FALSE(loaded.scene);
    EXPECT_THAT(all_problems(loaded), HasSubstr(file.filename().string() + GetParam().reason));
}

INSTANTIATE_TEST_SUITE_P(
    All, ImportRefusal,
    testing::Values(Refusal{"invalid/empty.obj", ": is empty"}, Refusal{"invalid/empty.ply", ": is empty"},
                    Refusal{"invalid/malformed.obj", ":23: vertex 12 does not exist"},
                    Refusal{"invalid/malformed.obj", ":28: vertex 0 does not exist"}, Refusal{"invalid/malformed2.obj", ":23: f is empty"},
                    Refusal{"invalid/OutOfMemory.off", ": unknown extension \".off\""}, Refusal{"OBJ/point_cloud.obj", ": has no faces"},
                    Refusal{"OBJ/number_formats.obj", ":11: v: \"3.1+e2\" is not a number"}, Refusal{"PLY/points.ply", ": has no faces"},
                    Refusal{"PLY/issue623.ply", ": has no faces"}, Refusal{"glTF/TwoBoxes/TwoBoxes.gltf", ": is glTF of version \"1.0\""},
                    Refusal{"glTF/BoxTextured-glTF-Binary/BoxTextured.glb", ": is binary glTF of version 1"},
                    Refusal{"glTF2/draco/2CylinderEngine.gltf", ": needs the extension KHR_draco_mesh_compression"},
                    Refusal{"glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb",
                            ": has nothing to draw: 12 faces with a coordinate that is not finite"},
                    Refusal{"glTF2/RecursiveNodes/RecursiveNodes.gltf", ": nodes[0]: is the child of two nodes"},
                    Refusal{"glTF2/IndexOutOfRange/IndexOutOfRange.gltf",
                            ": meshes[0].primitives[0]: index 0 is 255; there are 24 vertices"},
                    Refusal{"glTF2/MissingBin/BoxTextured.gltf", ": buffers[0]: the file \"BoxTextured0.bin\" does not exist"},
                    Refusal{"glTF2/wrongTypes/badArray.gltf", ": meshes[0].primitives: must be an array"}));

TEST(ImportModels, BunnyIsOneSmoothMesh) {
    const std::filesystem::path file = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "glmark2-data is not installed";
    const Loaded loaded = import_file(file);
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    ASSERT_EQ(loaded.scene->meshes.size(), 1u);
    EXPECT_EQ(loaded.scene->meshes[0].face_count(), 69666u);
    EXPECT_LE(loaded.scene->meshes[0].positions.size(), 35000u);
}

} // namespace
} // namespace lightbench
