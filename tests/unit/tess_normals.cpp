// Face and vertex normals against exact and long double oracles; creases; normals that would vanish (NI-1, NI-2, NI-3).
#include "scene/normals.h"

#include "scene/tessellate_placement.h"
#include "tess_support.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace lightbench {
namespace {

using namespace tess;
using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::cpp_bin_float_100;

constexpr float kPi = std::numbers::pi_v<float>;

// The cross product in exact fractions; made unit in 100 digits only.
glm::dvec3 exact_normal(const std::array<glm::vec3, 3>& p) {
    std::array<Rational, 3> a, b, n;
    for (int i = 0; i < 3; ++i) {
        a[std::size_t(i)] = Rational(double(p[1][i])) - Rational(double(p[0][i]));
        b[std::size_t(i)] = Rational(double(p[2][i])) - Rational(double(p[0][i]));
    }
    for (std::size_t i = 0; i < 3; ++i) n[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    const Wide x(n[0]), y(n[1]), z(n[2]), length = sqrt(x * x + y * y + z * z);
    if (length == 0) return glm::dvec3(0);
    return {double(x / length), double(y / length), double(z / length)};
}

TEST(TessNormals, SliversAgreeWithTheExactCross) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> anywhere(-1, 1);
    for (float ratio : {1e-2f, 1e-4f, 1e-6f, 1e-7f})
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 a(anywhere(random), anywhere(random), anywhere(random)),
                along(anywhere(random), anywhere(random), anywhere(random));
            const glm::vec3 off(anywhere(random), anywhere(random), anywhere(random));
            const std::array<glm::vec3, 3> p{a, a + along, a + 0.37f * along + ratio * off};
            const glm::dvec3 exact = exact_normal(p);
            const std::vector<glm::dvec3> points{p[0], p[1], p[2]};
            const Corner loop[] = {{0}, {1}, {2}};
            const glm::dvec3 normal = face_normal(points, loop);
            EXPECT_LE(glm::distance(normal, exact), 1e-6) << "0 where there is no area";
        }
}

TEST(TessNormals, FacesWithoutAreaAreDroppedAndCounted) {
    const auto mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, 0.2f}, {0.4f, 0.4f, 0.4f}},
                              {{0, 1, 2}, {0, 1, 1}, {3, 4, 5}, {0, 1, 0, 1}, {2, 2, 2}});
    for (bool normals : {true, false}) {
        const auto g = tessellate(scene_of_mesh(mesh), {.normals = normals});
        expect_sound(g, normals);
        EXPECT_EQ(g.indices.size(), 3u);
        EXPECT_EQ(g.dropped_degenerate, 4u);
    }
    EXPECT_EQ(
        tessellate(scene_of({Polygon{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {}}, Cone{{0, 0, 0}, {0, 0, 0}, 1, 1}}), {}).dropped_degenerate,
        2u);
    EXPECT_EQ(tessellate(scene_of({Box{}}, glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1))), {}).dropped_degenerate, 4u);
}

// Oracle: n' such that transpose(m) n' = n, by Gauss-Jordan elimination in 100 digits.
glm::dvec3 inverse_transpose_times(const glm::dmat3& m, const glm::dvec3& n) {
    std::array<std::array<Wide, 4>, 3> rows;
    for (int i = 0; i < 3; ++i) rows[std::size_t(i)] = {m[i].x, m[i].y, m[i].z, n[i]};
    for (std::size_t column = 0; column < 3; ++column) {
        std::size_t pivot = column;
        for (std::size_t r = column + 1; r < 3; ++r)
            if (abs(rows[r][column]) > abs(rows[pivot][column])) pivot = r;
        std::swap(rows[column], rows[pivot]);
        for (std::size_t r = 0; r < 3; ++r) {
            if (r == column) continue;
            const Wide factor = rows[r][column] / rows[column][column];
            for (std::size_t k = 0; k < 4; ++k) rows[r][k] -= factor * rows[column][k];
        }
    }
    const Wide x = rows[0][3] / rows[0][0], y = rows[1][3] / rows[1][1], z = rows[2][3] / rows[2][2], length = sqrt(x * x + y * y + z * z);
    return {double(x / length), double(y / length), double(z / length)};
}

TEST(TessNormals, NormalMatrixIsTheInverseTranspose) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(-1, 1), exponent(-6, 6);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        glm::dmat4 m = glm::rotate(glm::dmat4(1), 3 * anywhere(random), glm::dvec3(anywhere(random), anywhere(random), 1.1));
        const glm::dvec3 scale(exponent(random), exponent(random), exponent(random));
        m = glm::scale(m, glm::pow(glm::dvec3(10), scale) * glm::dvec3(1, 1, i % 2 ? -1 : 1));
        if (i % 3 == 0) m[1] += anywhere(random) * m[0];
        m = m * glm::rotate(glm::dmat4(1), anywhere(random), glm::dvec3(1, anywhere(random), 0));
        const glm::dvec3 n = glm::normalize(glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
        const glm::dvec3 made = glm::normalize(normal_matrix(glm::dmat3(m)) * n);
        worst = std::max(worst, glm::distance(made, inverse_transpose_times(glm::dmat3(m), n)));
        EXPECT_EQ(placement_of(m).mirrored, i % 2 == 1);
    }
    EXPECT_LE(worst, 4 * 0x1p-24);
}

std::size_t vertices_of_cube(float degrees) {
    const auto g = tessellate(scene_of_mesh(cube_mesh(), degrees / 180 * kPi), {.polygons = false});
    expect_sound(g, true, false);
    return g.vertices.positions.size();
}

TEST(TessNormals, CreaseSplitsTheCube) {
    EXPECT_EQ(vertices_of_cube(0), 24u);
    EXPECT_EQ(vertices_of_cube(30), 24u);
    EXPECT_EQ(vertices_of_cube(89.9f), 24u);
    EXPECT_EQ(vertices_of_cube(90.1f), 8u);
    EXPECT_EQ(vertices_of_cube(180), 8u);
    for (const auto& t : triangles_of(tessellate(scene_of_mesh(cube_mesh()), {})))
        for (const auto& n : t.n) EXPECT_LE(glm::distance(n, glm::normalize(t.cross())), 1e-7);
    for (const auto& t : triangles_of(tessellate(scene_of_mesh(cube_mesh(), kPi), {})))
        for (int k = 0; k < 3; ++k) EXPECT_LE(glm::distance(t.n[k], glm::normalize(t.p[k])), 2e-7) << "weights are angles, not triangles";
    const auto flat = tessellate(scene_of_mesh(cube_mesh()), {.normals = false, .polygons = false});
    EXPECT_EQ(flat.vertices.positions.size(), 8u);
}

// Six faces about an apex, half of them bent upwards: only what hangs together across smooth edges is averaged.
TEST(TessNormals, GroupsHangTogetherAcrossSmoothEdges) {
    std::vector<glm::vec3> p;
    std::vector<std::vector<std::uint32_t>> faces;
    p.emplace_back(0, 0, 1);
    const double heights[] = {0, 0, 0, 0.9, 0.9, 0.9};
    for (int i = 0; i < 6; ++i) p.emplace_back(std::cos(i * kPi / 3), std::sin(i * kPi / 3), heights[i]);
    for (std::uint32_t i = 0; i < 6; ++i) faces.push_back({0, 1 + i, 1 + (i + 1) % 6});
    const auto g = tessellate(scene_of_mesh(mesh_of(p, faces), 40.0f / 180 * kPi), {});
    // Independent: walk round the apex and break where the angle between neighbours is 40 degrees or more.
    std::vector<glm::dvec3> face(6);
    for (std::size_t i = 0; i < 6; ++i)
        face[i] = glm::normalize(glm::cross(glm::dvec3(p[1 + i] - p[0]), glm::dvec3(p[1 + (i + 1) % 6] - p[0])));
    std::set<Key> seen;
    std::size_t breaks = 0;
    for (std::size_t i = 0; i < 6; ++i) breaks += std::acos(glm::dot(face[i], face[(i + 1) % 6])) >= 40.0 / 180 * double(kPi);
    ASSERT_GE(breaks, 2u);
    for (const auto& t : triangles_of(g))
        for (int k = 0; k < 3; ++k)
            if (glm::distance(t.p[k] + g.frame.origin, glm::dvec3(0, 0, 1)) < 1e-6) seen.insert(key_of(t.n[k]));
    EXPECT_EQ(seen.size(), breaks);
}

// A regular corrugation of 90-degree ridges: smoothed across all edges its ridge normals point straight up, which is why it looks flat.
TEST(TessNormals, CorrugatedSheet) {
    const auto sheet = grid_mesh(20, [](float x, float) { return std::lround(x * 20) % 2 ? 0.05f : 0.0f; });
    for (const auto& t : triangles_of(tessellate(scene_of_mesh(sheet, kPi), {})))
        for (int k = 0; k < 3; ++k)
            if (std::abs(t.p[k].x) < 0.49) {
                EXPECT_LE(glm::distance(t.n[k], glm::dvec3(0, 0, 1)), 1e-6);
            }
    for (const auto& t : triangles_of(tessellate(scene_of_mesh(sheet), {})))
        for (int k = 0; k < 3; ++k) EXPECT_LE(glm::distance(t.n[k], glm::normalize(t.cross())), 1e-6);
}

double least_interpolated(const RasterGeometry& g) {
    double least = 2;
    for (const auto& t : triangles_of(g))
        for (int i = 0; i <= 10; ++i)
            for (int j = 0; i + j <= 10; ++j)
                least = std::min(least, glm::length(t.n[0] * double(i) + t.n[1] * double(j) + t.n[2] * double(10 - i - j)) / 10);
    return least;
}

TEST(TessNormals, ComputedNormalsNeverVanish) {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> anywhere(-1, 1);
    for (int i = 0; i < 40; ++i) {
        std::vector<glm::vec3> p;
        std::vector<std::vector<std::uint32_t>> faces;
        for (int k = 0; k < 30; ++k) p.emplace_back(anywhere(random), anywhere(random), anywhere(random));
        for (int k = 0; k < 60; ++k)
            faces.push_back({std::uint32_t(random() % 30), std::uint32_t(random() % 30), std::uint32_t(random() % 30)});
        for (unsigned subdivide : {0u, 1u}) {
            const auto g = tessellate(scene_of_mesh(mesh_of(p, faces), kPi), {.subdivide = subdivide});
            expect_sound(g);
            EXPECT_FALSE(g.normals_may_vanish);
            EXPECT_GE(least_interpolated(g), 0.0499);
        }
    }
    // A fold of nearly 180 degrees smoothed over: the mean of the two sides lies in both faces, and must not be used.
    const auto fold = mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0.001f}, {1, 0, -0.001f}}, {{0, 2, 1}, {0, 1, 3}});
    EXPECT_GE(least_interpolated(tessellate(scene_of_mesh(fold, kPi), {})), 0.0499);
}

TEST(TessNormals, FileNormalsAreKept) {
    Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    mesh.normals = {{0, 0.6f, 0.8f}, {0, 0, 3}, {1e-20f, 0, 1e-20f}};
    auto g = tessellate(scene_of_mesh(mesh), {});
    EXPECT_FALSE(g.normals_may_vanish);
    std::map<Key, glm::dvec3> at;
    for (const auto& t : triangles_of(g))
        for (int k = 0; k < 3; ++k) at[key_of(t.p[k] + g.frame.origin)] = t.n[k];
    EXPECT_LE(glm::distance(at[{0, 0, 0}], glm::dvec3(0, 0.6, 0.8)), 1e-7);
    EXPECT_LE(glm::distance(at[{1, 0, 0}], glm::dvec3(0, 0, 1)), 1e-7);
    EXPECT_LE(glm::distance(at[{0, 1, 0}], glm::normalize(glm::dvec3(1, 0, 1))), 1e-7) << "tiny normals are normals";
    mesh.normals = {{0, 0, 0}, {NAN, 0, 1}, {0, INFINITY, 0}};
    for (const auto& t : triangles_of(tessellate(scene_of_mesh(mesh), {})))
        for (const auto& n : t.n) EXPECT_EQ(n, glm::dvec3(0, 0, 1)) << "what is no normal is computed";
}

TEST(TessNormals, FileNormalsThatMayVanishAreReported) {
    Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const auto vanish = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        mesh.normals = {a, b, c};
        return tessellate(scene_of_mesh(mesh), {}).normals_may_vanish;
    };
    EXPECT_FALSE(vanish({0, 0, 1}, {0, 0.9f, 0.3f}, {0.9f, 0, 0.3f}));
    EXPECT_FALSE(vanish({0, 0, -1}, {0, 0, -1}, {0, 0.1f, -1})) << "all behind the face: none vanishes";
    EXPECT_TRUE(vanish({0, 0, 1}, {0, 0, -1}, {0, 0, 1}));
    EXPECT_TRUE(vanish({1, 0, 0}, {-1, 0, 0}, {0, 0, 1}));
    Polygon polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, -1}, {0, 0, 1}}};
    EXPECT_TRUE(tessellate(scene_of({polygon}), {}).normals_may_vanish);
    EXPECT_FALSE(tessellate(scene_of({polygon}), {.normals = false}).normals_may_vanish);
}

TEST(TessNormals, MirroredMeshesFaceOutwards) {
    Scene scene = scene_of_mesh(cube_mesh(), kPi);
    scene.transforms[1] = glm::scale(glm::dmat4(1), glm::dvec3(-1, 2, 1));
    const auto g = tessellate(scene, {});
    EXPECT_NEAR(volume_of(g), 2, 1e-5);
    for (const auto& t : triangles_of(g))
        for (const auto& n : t.n) EXPECT_GT(glm::dot(n, glm::normalize(t.cross())), 0.05);
    EXPECT_EQ(g.one_sided_clusters, g.clusters.size());
}

} // namespace
} // namespace lightbench
