// Surfaces: which materials need one an object, which mapping they really have, how it lies; the order of opaque and translucent clusters.
#include "scene/surfaces.h"
#include "tess_support.h"

namespace lightbench {
namespace {

using namespace tess;

glm::dvec3 mapped(const glm::dmat4& m, const glm::dvec3& p) {
    return glm::dvec3(m * glm::dvec4(p, 1));
}

void expect_maps(const glm::dmat4& m, const glm::dvec3& from, const glm::dvec3& to) {
    EXPECT_LE(glm::distance(mapped(m, from), to), 1e-12) << from.x << " " << from.y << " " << from.z;
}

Object object_of(Shape shape) {
    return {.shape = std::move(shape)};
}

Material textured(Mapping mapping) {
    Material m;
    m.texture = Texture{};
    m.texture->mapping = mapping;
    return m;
}

TEST(Surfaces, MaterialsThatDependOnTheObject) {
    Scene scene;
    scene.meshes.resize(2);
    scene.meshes[1].uvs.resize(3);
    const Object sphere = object_of(Sphere{}), bare = object_of(MeshUse{0}), with_uv = object_of(MeshUse{1});
    Material waves, height, both = textured(Mapping::planar);
    waves.bump = Bump{}, waves.bump->function = BumpFunction::waves;
    height.bump = Bump{}, height.bump->picture = 0;
    both.bump = height.bump;
    struct {
        Material material;
        bool sphere, bare, with_uv;
    } const rows[] = {
        {Material{}, false, false, false},
        {textured(Mapping::uv), true, true, false},
        {textured(Mapping::spherical), true, true, true},
        {waves, true, true, true},
        {height, true, true, false},
        {both, true, true, true},
    };
    for (const auto& row : rows) {
        EXPECT_EQ(depends_on_object(row.material, scene, sphere), row.sphere) << &row - rows;
        EXPECT_EQ(depends_on_object(row.material, scene, bare), row.bare) << &row - rows;
        EXPECT_EQ(depends_on_object(row.material, scene, with_uv), row.with_uv) << &row - rows;
    }
}

TEST(Surfaces, UvGivesWayWhereThereIsNone) {
    Scene scene;
    scene.meshes.resize(2);
    scene.meshes[1].uvs.resize(3);
    const Material uv = textured(Mapping::uv), planar = textured(Mapping::planar);
    EXPECT_EQ(mapping_of(scene, object_of(Sphere{}), uv), Mapping::spherical);
    EXPECT_EQ(mapping_of(scene, object_of(Torus{}), uv), Mapping::spherical);
    EXPECT_EQ(mapping_of(scene, object_of(Cylinder{}), uv), Mapping::cylindrical);
    EXPECT_EQ(mapping_of(scene, object_of(Cone{}), uv), Mapping::cylindrical);
    EXPECT_EQ(mapping_of(scene, object_of(Polygon{}), uv), Mapping::planar);
    EXPECT_EQ(mapping_of(scene, object_of(Box{}), uv), Mapping::planar);
    EXPECT_EQ(mapping_of(scene, object_of(MeshUse{0}), uv), Mapping::planar);
    EXPECT_EQ(mapping_of(scene, object_of(MeshUse{1}), uv), Mapping::uv);
    EXPECT_EQ(mapping_of(scene, object_of(Sphere{}), planar), Mapping::planar);
    EXPECT_EQ(mapping_of(scene, object_of(MeshUse{1}), planar), Mapping::planar);
}

TEST(Surfaces, PolarAxesAndFronts) {
    const Scene scene;
    const Object sphere = object_of(Sphere{{1, 2, 3}, 2});
    for (const Mapping mapping : {Mapping::uv, Mapping::spherical, Mapping::cylindrical}) {
        const glm::dmat4 m = mapping_from_object(scene, sphere, mapping);
        expect_maps(m, {1, 4, 3}, {0, 0, 1});
        expect_maps(m, {1, 2, 5}, {-1, 0, 0}); // the front: half a turn from the seam
        expect_maps(m, {3, 2, 3}, {0, -1, 0}); // u grows to the right as seen from the front
        EXPECT_EQ(metres_per_mapping_unit(scene, sphere, mapping), glm::dvec3(2));
    }
    const Object lying = object_of(Cylinder{{-3, 1, 0}, {5, 1, 0}, 0.5});
    const glm::dmat4 m = mapping_from_object(scene, lying, Mapping::cylindrical);
    expect_maps(m, {5, 1, 0}, {0, 0, 1});
    expect_maps(m, {1, 1, 0.5}, {-1, 0, 0});
    EXPECT_EQ(metres_per_mapping_unit(scene, lying, Mapping::cylindrical), glm::dvec3(0.5, 0.5, 4));
    const Object ring = object_of(Torus{{0, 0, 0}, {0, 0, 3}, 2, 0.5});
    const glm::dmat4 r = mapping_from_object(scene, ring, Mapping::spherical);
    expect_maps(r, {0, 0, 0.5}, {0, 0, 1});
    EXPECT_EQ(metres_per_mapping_unit(scene, ring, Mapping::spherical), glm::dvec3(2.5, 2.5, 0.5));
}

TEST(Surfaces, PlanesAreSeenUpright) {
    const Scene scene;
    const glm::dmat4 wall = mapping_from_object(scene, object_of(Polygon{{{0, 0, 7}, {4, 0, 7}, {4, 2, 7}, {0, 2, 7}}, {}}), Mapping::uv);
    expect_maps(wall, {0, 0, 7}, {-1, -1, 0});
    expect_maps(wall, {4, 2, 8}, {1, 1, 1}); // flat: the half extent is 1
    const Object floor = object_of(Polygon{{{0, 3, 0}, {0, 3, 2}, {4, 3, 2}, {4, 3, 0}}, {}});
    expect_maps(mapping_from_object(scene, floor, Mapping::planar), {0, 3, 2}, {-1, -1, 0});
    expect_maps(mapping_from_object(scene, floor, Mapping::planar), {4, 3, 0}, {1, 1, 0});
    EXPECT_EQ(metres_per_mapping_unit(scene, floor, Mapping::planar), glm::dvec3(2, 1, 1));
    const glm::dmat4 side = mapping_from_object(scene, object_of(Box{{0, 0, 0}, {0.5, 2, 6}}), Mapping::planar);
    expect_maps(side, {0.5, 0, 6}, {-1, -1, 1});
    expect_maps(side, {0, 2, 0}, {1, 1, -1});
    const glm::dmat4 cube = mapping_from_object(scene, object_of(Box{{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}}), Mapping::planar);
    expect_maps(cube, {1.1, 1.2, 1.3}, {1, 1, 1});
}

TEST(Surfaces, MappingsAreRightHandedRotationsOfBoxes) {
    Scene scene = scene_of_mesh(grid_mesh(2, [](float x, float) { return x; }));
    scene.meshes[0].positions.push_back({1e9f, 0, 0}); // used by no face
    std::mt19937 random(7);
    std::uniform_real_distribution<double> d(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 a(d(random), d(random), d(random)), b(d(random), d(random), d(random));
        for (const Shape& shape :
             {Shape(Cylinder{a, b, 0.3}), Shape(Cone{a, b, 0.3, 0.1}), Shape(Torus{a, b, 1, 0.2}), Shape(Sphere{a, 0.4}),
              Shape(Polygon{{a, b, {0, 0, 0}}, {}}), Shape(MeshUse{0}), Shape(Cylinder{a, a, 0.3})})
            for (const Mapping mapping : {Mapping::uv, Mapping::spherical, Mapping::cylindrical, Mapping::planar}) {
                const Object object = object_of(shape);
                const glm::dmat3 m(mapping_from_object(scene, object, mapping));
                const glm::dvec3 metres = metres_per_mapping_unit(scene, object, mapping);
                glm::dmat3 rows = glm::transpose(m);
                for (int k = 0; k < 3; ++k) rows[k] *= metres[k];
                const glm::dmat3 gram = glm::transpose(rows) * rows;
                for (int k = 0; k < 3; ++k)
                    for (int j = 0; j < 3; ++j) EXPECT_NEAR(gram[k][j], k == j, 1e-12);
                EXPECT_NEAR(glm::determinant(rows), 1, 1e-12);
            }
    }
    EXPECT_EQ(metres_per_mapping_unit(scene, scene.objects[0], Mapping::uv), glm::dvec3(0.5));
}

TEST(Surfaces, AreNumberedByFirstUse) {
    Scene scene = scene_of({Sphere{}, Sphere{{3, 0, 0}}, Box{{5, 0, 0}, {6, 1, 1}}, Sphere{{9, 0, 0}}, Sphere{{12, 0, 0}}});
    scene.materials.resize(4);
    scene.materials[3] = textured(Mapping::spherical);
    for (const std::size_t i : {0u, 1u, 2u, 3u, 4u}) scene.objects[i].material = std::array{2u, 3u, 2u, 3u, 0u}[i];
    const auto g = tessellate(scene, {.eye = {0, 0, 30}});
    EXPECT_EQ(g.surfaces, (std::vector<Surface>{{2, 0}, {3, 1}, {3, 3}, {0, 4}}));
    expect_sound(g);
    for (std::size_t i = 0; i < g.polygons.normals.size(); ++i)
        EXPECT_EQ(g.surfaces[g.polygons.normals[i].material].material, scene.objects[g.polygon_objects[i]].material);
    EXPECT_EQ(tessellate(scene, {.normals = false}).surfaces, g.surfaces);
    EXPECT_EQ(tessellate(scene, {.polygons = false}).surfaces, g.surfaces);
}

// The material of each cluster's first triangle, by its polygon.
std::vector<std::uint32_t> materials_of_clusters(const RasterGeometry& g) {
    std::vector<std::uint32_t> materials;
    for (const Cluster& c : g.clusters)
        materials.push_back(g.surfaces[g.polygons.normals[g.vertices.positions[g.indices[c.first_index]].polygon].material].material);
    return materials;
}

TEST(Surfaces, TranslucentClustersComeLast) {
    std::vector<Shape> shapes;
    for (int i = 0; i < 4; ++i) shapes.emplace_back(Box{{2 * i, 0, 0}, {2 * i + 1, 1, 1}});
    Scene scene = scene_of(shapes);
    scene.materials.resize(4);
    scene.materials[0].opacity = {1, 0.5f, 1};
    scene.materials[1].opacity = glm::vec3(0), scene.materials[1].two_sided = false;
    scene.materials[2].two_sided = true;
    for (std::uint32_t i = 0; i < 4; ++i) scene.objects[i].material = i;
    auto g = tessellate(scene, {});
    expect_sound(g);
    expect_provoked_in_plane(g);
    EXPECT_EQ(materials_of_clusters(g), (std::vector<std::uint32_t>{3, 2, 1, 0}));
    EXPECT_EQ(g.one_sided_clusters, 1u);
    EXPECT_EQ(g.opaque_clusters, 2u);
    EXPECT_EQ(g.translucent_one_sided_clusters, 1u);
    EXPECT_EQ(g.faces_two_sided, 12u);
}

TEST(Surfaces, MeshesOfBothKindsAreSplitByTriangle) {
    Scene scene = scene_of_mesh(cube_mesh());
    scene.materials.resize(3);
    scene.materials[1].opacity = glm::vec3(0.5f);
    scene.meshes[0].face_materials = {0, 1, 0, 1, 0, 0};
    auto g = tessellate(scene, {});
    expect_sound(g);
    expect_provoked_in_plane(g);
    EXPECT_EQ(materials_of_clusters(g), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(g.one_sided_clusters, 0u) << "through a window the insides of the walls are seen";
    EXPECT_EQ(g.opaque_clusters, 1u);
    EXPECT_EQ(g.clusters[0].index_count, 24u);
    EXPECT_EQ(g.clusters[1].index_count, 12u);
    EXPECT_EQ(g.faces_two_sided, 6u);
    scene.materials[0].two_sided = scene.materials[1].two_sided = false;
    g = tessellate(scene, {});
    EXPECT_EQ(g.one_sided_clusters, 1u);
    EXPECT_EQ(g.translucent_one_sided_clusters, 1u);
    EXPECT_EQ(g.faces_two_sided, 0u);
}

} // namespace
} // namespace lightbench
