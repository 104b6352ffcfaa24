// Meshes: welding, sidedness, materials, subdivision, provoking vertices, centres, the limit.
#include "scene/limits.h"
#include "tess_support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace lightbench {
namespace {

using namespace tess;

Mesh split_to_soup(const Mesh& mesh) { // every corner a vertex of its own, as STL has it
    Mesh soup = mesh;
    soup.positions.clear();
    for (std::uint32_t& c : soup.corners) {
        soup.positions.push_back(mesh.positions[c]);
        c = static_cast<std::uint32_t>(soup.positions.size() - 1);
    }
    return soup;
}

TEST(TessMesh, EqualPositionsAreWelded) {
    Mesh soup = split_to_soup(cube_mesh());
    for (auto& p : soup.positions)
        if (p.x == 0) p.x = soup.positions.size() % 2 ? 0.0f : -0.0f;
    soup.positions[0].x = soup.positions[0].x == 0 ? 0.0f : soup.positions[0].x;
    const auto g = tessellate(scene_of_mesh(soup, 3.2f), {.polygons = false});
    EXPECT_EQ(g.vertices.positions.size(), 8u);
    EXPECT_EQ(g.one_sided_clusters, g.clusters.size());
}

TEST(TessMesh, OneSidedIffClosedAndOutward) {
    const auto two_sided = [](const Mesh& mesh) { return tessellate(scene_of_mesh(mesh), {}).one_sided_clusters == 0; };
    Mesh open = cube_mesh(), inward = cube_mesh(), turned = cube_mesh(), doubled = cube_mesh(), far = cube_mesh();
    open.corners.resize(20), open.face_starts.pop_back();
    for (std::size_t f = 0; f < 6; ++f) std::reverse(inward.corners.begin() + long(4 * f), inward.corners.begin() + long(4 * f + 4));
    std::reverse(turned.corners.begin(), turned.corners.begin() + 4);
    doubled.corners.insert(doubled.corners.end(), doubled.corners.begin(), doubled.corners.end());
    for (std::uint32_t f = 0; f < 6; ++f) doubled.face_starts.push_back(28 + 4 * f);
    for (auto& p : far.positions) p = 0.01f * p + glm::vec3(-30, 20, 10);
    EXPECT_FALSE(two_sided(cube_mesh()));
    EXPECT_FALSE(two_sided(split_to_soup(cube_mesh())));
    EXPECT_FALSE(two_sided(far));
    EXPECT_TRUE(two_sided(open));
    EXPECT_TRUE(two_sided(inward));
    EXPECT_TRUE(two_sided(turned)) << "an edge is run along twice the same way";
    EXPECT_TRUE(two_sided(doubled)) << "edges are shared by four";
    // An outward cube beside a smaller inward one: the sum of the volumes is positive, yet a back is seen.
    Mesh both = cube_mesh();
    for (const auto& p : inward.positions) both.positions.push_back(0.5f * p + glm::vec3(3, 0, 0));
    for (std::size_t i = 0; i < 24; ++i) both.corners.push_back(inward.corners[i] + 8);
    for (std::uint32_t f = 0; f < 6; ++f) both.face_starts.push_back(28 + 4 * f);
    EXPECT_TRUE(two_sided(both));
}

TEST(TessMesh, MaterialsOfFacesSplitVerticesAndDecideSides) {
    Scene scene = scene_of_mesh(grid_mesh(2, [](float, float) { return 0.0f; }));
    scene.materials.resize(3);
    scene.meshes[0].face_materials = {1, 2, 1, 2};
    auto g = tessellate(scene, {.polygons = false});
    EXPECT_EQ(g.vertices.positions.size(), 12u) << "3 x 3 points, of which a column of 3 belongs to both materials";
    g = tessellate(scene, {});
    std::map<std::uint32_t, int> faces;
    for (const auto& n : g.polygons.normals) ++faces[g.surfaces[n.material].material];
    EXPECT_EQ(faces, (std::map<std::uint32_t, int>{{1, 2}, {2, 2}}));
    for (std::size_t i = 0; i < g.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(g.vertices.normals[g.indices[i + k]].material,
                      g.polygons.normals[g.vertices.positions[g.indices[i]].polygon].material);
    scene.materials[1].two_sided = scene.materials[2].two_sided = false;
    EXPECT_EQ(tessellate(scene, {}).one_sided_clusters, 1u);
    scene.materials[2].two_sided = true;
    EXPECT_EQ(tessellate(scene, {}).one_sided_clusters, 0u);
}

TEST(TessMesh, SubdivisionKeepsShapeAndSeams) {
    const Mesh cube = cube_mesh();
    for (unsigned levels : {1u, 2u, 3u})
        for (bool normals : {true, false}) {
            const auto g = tessellate(scene_of_mesh(cube), {.subdivide = levels, .normals = normals});
            expect_sound(g, normals);
            expect_provoked_in_plane(g);
            EXPECT_EQ(g.polygons.positions.size(), std::size_t(6) << (2 * levels));
            EXPECT_TRUE(topology_of(g).closed);
            EXPECT_EQ(topology_of(g).euler, 2);
            EXPECT_NEAR(volume_of(g), 1, 1e-6);
        }
    const Mesh arrow = mesh_of({{0, 0, 0}, {1, 1, 0}, {0, 2, 0}, {3, 1, 0}}, {{0, 1, 2, 3}});
    auto g = tessellate(scene_of_mesh(arrow), {.subdivide = 2});
    EXPECT_NEAR(area_of(g), 2, 1e-6);
    for (const auto& t : triangles_of(g)) EXPECT_LT(t.cross().z, 0) << "the arrow is clockwise seen from above, and stays so";
    const Mesh pentagon = mesh_of({{1, 0, 0}, {0.3f, 0.95f, 0}, {-0.8f, 0.6f, 0}, {-0.8f, -0.6f, 0}, {0.3f, -0.95f, 0}}, {{0, 1, 2, 3, 4}});
    EXPECT_EQ(tessellate(scene_of_mesh(pentagon), {.subdivide = 1}).polygons.positions.size(), 5u);
    EXPECT_EQ(tessellate(scene_of_mesh(pentagon), {.subdivide = 2}).polygons.positions.size(), 20u);
}

TEST(TessMesh, SubdivisionInterpolatesNormals) {
    Scene scene = scene_of_mesh(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
    scene.meshes[0].normals = {{-0.6f, 0, 0.8f}, {0.6f, 0, 0.8f}, {0, 0, 1}};
    scene.objects[0].subdivide = 1;
    const auto g = tessellate(scene, {});
    bool found = false;
    for (const auto& t : triangles_of(g))
        for (int k = 0; k < 3; ++k)
            if (glm::distance(t.p[k] + g.frame.origin, glm::dvec3(0.5, 0, 0)) < 1e-6) {
                EXPECT_LE(glm::distance(t.n[k], glm::dvec3(0, 0, 1)), 1e-7);
                found = true;
            }
    EXPECT_TRUE(found);
}

TEST(TessMesh, ProvokingVerticesAreFew) {
    const auto quads = grid_mesh(60, [](float x, float y) { return x * y; });
    Mesh triangles = quads;
    triangles.corners.clear(), triangles.face_starts = {0};
    for (std::size_t f = 0; f < quads.face_count(); ++f) {
        const std::uint32_t* c = &quads.corners[4 * f];
        triangles.corners.insert(triangles.corners.end(), {c[0], c[1], c[2], c[0], c[2], c[3]});
        triangles.face_starts.push_back(static_cast<std::uint32_t>(triangles.corners.size() - 3));
        triangles.face_starts.push_back(static_cast<std::uint32_t>(triangles.corners.size()));
    }
    const auto q = tessellate(scene_of_mesh(quads), {.normals = false}), t = tessellate(scene_of_mesh(triangles), {.normals = false});
    expect_sound(q, false);
    expect_sound(t, false);
    expect_provoked_in_plane(t);
    EXPECT_LE(q.vertices.positions.size(), 61u * 61u * 102 / 100) << "as many points as quads: hardly a copy is needed";
    EXPECT_LE(t.vertices.positions.size(), 7200u * 102 / 100) << "no fewer than the 7200 polygons would do";
    std::map<std::uint32_t, std::size_t> uses;
    for (std::size_t i = 0; i < t.indices.size(); i += 3) ++uses[t.vertices.positions[t.indices[i]].polygon];
    EXPECT_EQ(uses.size(), 7200u);
    for (const auto& [polygon, count] : uses) EXPECT_EQ(count, 1u);
    Polygon fan;
    for (int i = 0; i < 50; ++i) fan.points.emplace_back(std::cos(0.12 * i), std::sin(0.12 * i), 0);
    EXPECT_EQ(tessellate(scene_of({fan}), {}).vertices.positions.size(), 50u);
    const auto none = tessellate(scene_of_mesh(triangles), {.normals = false, .polygons = false});
    expect_sound(none, false, false);
    EXPECT_EQ(none.vertices.positions.size(), 61u * 61u);
}

TEST(TessMesh, PolygonsNameTheirObjectCenterAndNormal) {
    Scene scene = scene_of({Polygon{{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {1, 2, 0}, {0, 1, 0}}, {}}, Box{{5, 5, 5}, {6, 6, 6}}});
    const auto g = tessellate(scene, {});
    ASSERT_EQ(g.polygons.positions.size(), 7u);
    EXPECT_EQ(g.polygon_objects, (std::vector<std::uint32_t>{0, 1, 1, 1, 1, 1, 1}));
    const glm::dvec3 center = glm::dvec3(g.polygons.positions[0].position) / g.frame.scale + g.frame.origin;
    EXPECT_LE(glm::distance(center, glm::dvec3(1.8, 1, 0)), 1e-6) << "the mean of the five corners, not of the area or the triangles";
    EXPECT_EQ(g.polygons.normals[0].normal, glm::vec3(0, 0, 1));
}

TEST(TessMesh, PatchesOfAPolygonFileShareVertices) {
    std::vector<Shape> patches;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) {
            const glm::dvec3 o(x, y, 0);
            patches.push_back(Polygon{{o, o + glm::dvec3(1, 0, 0), o + glm::dvec3(1, 1, 0), o + glm::dvec3(0, 1, 0)}, {}});
        }
    const auto g = tessellate(scene_of(patches), {.polygons = false});
    expect_sound(g, true, false);
    EXPECT_EQ(g.vertices.positions.size(), 121u);
    const auto flat = tessellate(scene_of(patches), {.normals = false});
    expect_sound(flat, false);
    expect_provoked_in_plane(flat);
    EXPECT_LE(flat.vertices.positions.size(), 123u);
}

TEST(TessMesh, TooManyTrianglesAreRefusedBeforeTheyAreMade) {
    Scene scene = scene_of_mesh(grid_mesh(50, [](float, float) { return 0.0f; }));
    scene.objects.resize(300, scene.objects[0]);
    try {
        tessellate(scene, {.subdivide = 8});
        FAIL();
    } catch (const std::length_error& e) {
        EXPECT_NE(std::string(e.what()).find("kMaxTriangles"), std::string::npos) << e.what();
    }
    EXPECT_THROW(tessellate(scene_of({Sphere{}}), {.eye = {0, 0, 3}, .pixel_angle = 1e-6, .subdivide = 8}), std::length_error);
}

} // namespace
} // namespace lightbench
