// PLY and STL: polygons, both byte orders, welding, and counts that the file does not keep.
#include "unit/import_support.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace lightbench {
namespace {

using namespace importer_test;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view kPlyText =
    "ply\nformat ascii 1.0\ncomment a quad and a triangle\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 1\n4 0 1 2 3\n3 1 4 2\n";

std::string ply_binary(bool big) {
    std::string file = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                       "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const auto put = [&file, big](auto value) {
        std::string bytes;
        append(bytes, value);
        if (big) std::reverse(bytes.begin(), bytes.end());
        file += bytes;
    };
    for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f}) put(value);
    file += '\3';
    for (const std::int32_t index : {0, 1, 2}) put(index);
    return file;
}

std::string stl_binary(std::uint32_t said, const std::vector<glm::vec3>& corners) {
    std::string file(80, ' ');
    file.replace(0, 5, "solid"); // as some writers do in binary files too
    append(file, said);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        file += packed<float>({9, 9, 9}); // a facet normal that is wrong, and is not used
        for (std::size_t k = 0; k < 3; ++k) file += packed<float>({corners[i + k].x, corners[i + k].y, corners[i + k].z});
        append(file, std::uint16_t{0});
    }
    return file;
}

TEST(ImportPly, KeepsPolygons) {
    const Loaded loaded = import_text("a.ply", kPlyText);
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    const Mesh& mesh = loaded.scene->meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 5u);
    EXPECT_THAT(mesh.face_starts, ElementsAre(0, 4, 7));
    EXPECT_THAT(corners(mesh, 1), ElementsAre(glm::vec3(1, 0, 0), glm::vec3(2, 0, 1), glm::vec3(1, 1, 0)));
    EXPECT_TRUE(mesh.normals.empty());
}

TEST(ImportPly, ReadsBothByteOrders) {
    for (const bool big : {false, true}) {
        const Loaded loaded = import_text("a.ply", ply_binary(big));
        ASSERT_TRUE(loaded.scene) << all_problems(loaded);
        EXPECT_THAT(corners(loaded.scene->meshes.at(0), 0), ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 2, 0)));
    }
}

TEST(ImportPly, LeavesOutFacesThatAreNotFinite) {
    std::string text(kPlyText);
    text.replace(text.find("2 0 1\n"), 5, "nan 0 1");
    const Loaded loaded = import_text("a.ply", text);
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    EXPECT_EQ(loaded.scene->meshes.at(0).face_count(), 1u);
    EXPECT_THAT(all_remarks(loaded), HasSubstr("1 faces with a coordinate that is not finite are left out"));
}

struct BadPly {
    std::string_view from, to, problem;
};

class ImportPlyProblem : public testing::TestWithParam<BadPly> {};

TEST_P(ImportPlyProblem, IsNamed) {
    std::string text(kPlyText);
    text.replace(text.find(GetParam().from), GetParam().from.size(), GetParam().to);
    const Loaded loaded = import_text("bad.ply", text);
    EXPECT_FALSE(loaded.scene);
    EXPECT_THAT(all_problems(loaded), HasSubstr("bad.ply" + std::string(GetParam().problem)));
}

INSTANTIATE_TEST_SUITE_P(All, ImportPlyProblem,
                         testing::Values(BadPly{"ply\n", "plx\n", ": is no PLY"},
                                         BadPly{"ascii", "asciii", ":2: format \"asciii\" is unknown"},
                                         BadPly{"vertex 5", "vertex 4000000000", ":4: 4000000000 elements \"vertex\" cannot be in"},
                                         BadPly{"vertex 5", "vertex -5", ":4: element \"vertex\": \"-5\" is no count"},
                                         BadPly{"end_header\n", "", ": its header does not end"},
                                         BadPly{"float z", "float w", ":4: the vertices have no z"},
                                         BadPly{"vertex_indices", "indices", ":8: the faces have no list"},
                                         BadPly{"face 2", "face 3", ":18: face 3 of 3: it ends too early"},
                                         BadPly{"3 1 4 2", "3 1 5 2", ":17: face 2 of 2: vertex 5 does not exist"},
                                         BadPly{"3 1 4 2", "3 1 -1 2", ":17: face 2 of 2: vertex -1 does not exist"},
                                         BadPly{"1 1 0\n", "1 x 0\n", ":13: vertex 3 of 5: \"x\" is not a number"},
                                         BadPly{"4 0 1 2 3", "70000 0 1 2 3", ":16: face 1 of 2: a list of 70000 values"},
                                         BadPly{"element face 2\nproperty list uchar int vertex_indices\n", "", ": has no faces"}));

TEST(ImportStl, WeldsByPositionAndDropsFacetNormals) {
    const Loaded loaded = import_text("a.stl", stl_binary(2, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-0.0f, 1, 0}}));
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    const Mesh& mesh = loaded.scene->meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 4u) << "0 and -0 are the same place";
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_THAT(corners(mesh, 1), ElementsAre(glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
}

TEST(ImportStl, ReadsText) {
    const Loaded loaded = import_text(
        "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1e1 0 0\nvertex 0 +1. 0\nendloop\nendfacet\nendsolid a\n");
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    EXPECT_THAT(corners(loaded.scene->meshes.at(0), 0), ElementsAre(glm::vec3(0, 0, 0), glm::vec3(10, 0, 0), glm::vec3(0, 1, 0)));
}

TEST(ImportStl, NamesWhatIsWrong) {
    const std::vector<glm::vec3> one = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_THAT(all_problems(import_text("a.stl", stl_binary(2, one).substr(0, 134).replace(0, 5, "Solid"))),
                HasSubstr("2 triangles, which take 184 bytes; it has 134"));
    EXPECT_THAT(all_problems(import_text("a.stl", stl_binary(0xFFFFFFFF, one).replace(0, 5, "xxxxx"))), HasSubstr("4294967295 triangles"));
    EXPECT_THAT(all_problems(import_text("a.stl", stl_binary(0, {}))), HasSubstr("has no triangles"));
    EXPECT_THAT(all_problems(import_text("a.stl", "hello")), HasSubstr("is no STL"));
    EXPECT_THAT(all_problems(import_text("a.stl", "solid\nendsolid\n")), HasSubstr("has no facets"));
    EXPECT_THAT(
        all_problems(import_text("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex 1 0 0\nendloop\nendfacet\nwhat\n")),
        testing::AllOf(HasSubstr("a.stl:4: vertex has 2 numbers"), HasSubstr("a.stl:7: the facet that ends here has 2 vertices"),
                       HasSubstr("a.stl:8: \"what\" has no meaning")));
}

TEST(ImportStl, RemarksBytesBehindTheTriangles) {
    const Loaded loaded = import_text("a.stl", stl_binary(1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).replace(0, 5, "xxxxx") + "more");
    ASSERT_TRUE(loaded.scene) << all_problems(loaded);
    EXPECT_THAT(all_remarks(loaded), HasSubstr("4 bytes after the last triangle"));
}

} // namespace
} // namespace lightbench
