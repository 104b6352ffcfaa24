// Clusters: every triangle once, spheres that hold, cones that never cull what is seen, order that owes nothing to threads.
#include "scene/clusters.h"
#include "tess_support.h"

#include <numbers>

namespace lightbench {
namespace {

using namespace tess;

Scene varied() {
    Scene scene = scene_of(
        {Sphere{{0, 0, 0}, 1}, Torus{{3, 0, 0}, {0, 1, 1}, 1, 0.3}, Box{{-4, -1, -1}, {-2, 1, 1}}, Cone{{0, 3, 0}, {0, 5, 0}, 1, 0}});
    scene.meshes.push_back(grid_mesh(80, [](float x, float y) { return 0.2f * std::sin(9 * x) * std::cos(7 * y); }));
    scene.objects.push_back({.shape = MeshUse{0}});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-6, 6);
    for (int i = 0; i < 500; ++i) scene.objects.push_back({.shape = Sphere{{anywhere(random), anywhere(random), anywhere(random)}, 0.01}});
    return scene;
}

const RasterGeometry& geometry() {
    static const RasterGeometry g = tessellate(varied(), {.eye = {0, 0, 20}});
    return g;
}

// Any triangles, doubled and degenerate ones too, more than one piece of them: the order is a permutation, and its runs add up.
TEST(TessClusters, CoverEveryTriangleOnce) {
    expect_sound(geometry());
    std::mt19937 random(9);
    std::uniform_real_distribution<float> anywhere(-1, 1);
    for (std::size_t count : {1u, 5u, 200u, 50'000u}) {
        std::vector<gpu_layout::PointPosition> vertices(count / 2 + 3);
        for (auto& v : vertices) v.position = {anywhere(random), anywhere(random), anywhere(random)};
        std::vector<std::array<std::uint32_t, 3>> triangles(count);
        const auto vertex = [&] { return static_cast<std::uint32_t>(random() % vertices.size()); };
        for (auto& t : triangles) t = {vertex(), vertex(), vertex()};
        for (std::size_t i = 0; i < count / 10; ++i) triangles[i] = triangles[count - 1 - i];
        ClusterOrder order = cluster_order(vertices, triangles);
        std::size_t sum = 0;
        for (std::uint32_t size : order.sizes) {
            EXPECT_LE(size, kMaxClusterTriangles);
            sum += size;
        }
        EXPECT_EQ(sum, count);
        ASSERT_EQ(order.triangles.size(), count);
        std::sort(order.triangles.begin(), order.triangles.end());
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(order.triangles[i], i);
    }
}

TEST(TessClusters, SpheresHoldTheirVertices) {
    const RasterGeometry& g = geometry();
    for (const Cluster& c : g.clusters)
        for (std::uint32_t i = 0; i < c.index_count; ++i)
            EXPECT_LE(glm::distance(glm::dvec3(g.vertices.positions[g.indices[c.first_index + i]].position), glm::dvec3(c.center)),
                      c.radius);
}

// The test as a renderer makes it in float32, from many eyes; a triangle is seen from before if the eye is on the front of its plane.
TEST(TessClusters, ConesNeverCullWhatIsSeen) {
    const RasterGeometry& g = geometry();
    std::mt19937 random(8);
    std::normal_distribution<float> anywhere(0, 1);
    std::size_t culled = 0, hidden = 0, tests = 0;
    for (int e = 0; e < 400; ++e) {
        const glm::vec3 eye = glm::vec3(anywhere(random), anywhere(random), anywhere(random)) * (e % 2 ? 1.0f : 30.0f);
        for (std::size_t i = 0; i < g.one_sided_clusters; ++i) {
            const Cluster& c = g.clusters[i];
            const glm::vec3 d = c.center - eye;
            const bool away = glm::dot(d, c.cone_axis) >= c.cone_cutoff * glm::length(d) + c.radius;
            bool all_hidden = true;
            for (std::uint32_t k = 0; k < c.index_count && (away || all_hidden); k += 3) {
                const auto p = [&](std::uint32_t j) { return glm::dvec3(g.vertices.positions[g.indices[c.first_index + k + j]].position); };
                const glm::dvec3 cross = glm::cross(p(1) - p(0), p(2) - p(0));
                const bool front = glm::dot(cross, glm::dvec3(eye) - p(0)) > 0;
                all_hidden = all_hidden && !front;
                if (away) {
                    EXPECT_FALSE(front);
                }
            }
            ++tests, culled += away, hidden += all_hidden;
        }
    }
    EXPECT_GT(culled, hidden / 2) << "the cones are worth their while";
    EXPECT_GT(hidden, tests / 20);
}

TEST(TessClusters, OneSidedOnesComeFirst) {
    const RasterGeometry& g = geometry();
    EXPECT_GT(g.one_sided_clusters, 0u);
    EXPECT_LT(g.one_sided_clusters, g.clusters.size());
    EXPECT_EQ(g.faces_two_sided, 6400u) << "the sheet";
}

TEST(TessClusters, ManySmallObjectsShareClusters) {
    std::vector<Shape> spheres;
    for (int i = 0; i < 4096; ++i) spheres.push_back(Sphere{{double(i % 16), double(i / 16 % 16), double(i / 256)}, 0.3});
    const auto g = tessellate(scene_of(spheres), {.eye = {0, 0, 3000}, .polygons = false});
    expect_sound(g, true, false);
    EXPECT_GE(double(g.indices.size()) / 3 / double(g.clusters.size()), 64);
    double volume = 0;
    for (const Cluster& c : g.clusters) volume += std::pow(double(c.radius) / g.frame.scale, 3);
    EXPECT_LE(volume, 2 * 16 * 16 * 16.0) << "and the clusters are round";
}

TEST(TessClusters, VerticesAreInTheOrderOfTheirUse) {
    const RasterGeometry& g = geometry();
    std::uint32_t next = 0;
    for (std::uint32_t i : g.indices) {
        EXPECT_LE(i, next);
        next = std::max(next, i + 1);
    }
}

} // namespace
} // namespace lightbench
