// The stream of detail: uv and its gradients against closed forms; seams, mirrors, tangents, uv without area, subdivision, what costs nothing.
#include "tess_support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace lightbench {
namespace {

using namespace tess;

constexpr double kPi = std::numbers::pi;

Mesh with_uv(Mesh mesh, glm::vec2 (*uv)(const glm::vec3&)) {
    for (const auto& p : mesh.positions) mesh.uvs.push_back(uv(p));
    return mesh;
}

Mesh flat_grid() {
    return with_uv(grid_mesh(4, [](float, float) { return 0.0f; }), [](const glm::vec3& p) { return glm::vec2(3 * p.x, 2 * p.y + p.x); });
}

// A cylinder's side of radius 2 about y, n quads around, u once around, v along; the seam's vertices are doubled.
Mesh tube(std::uint32_t n) {
    Mesh mesh;
    mesh.face_starts = {0};
    for (std::uint32_t i = 0; i <= n; ++i)
        for (int y = 0; y < 2; ++y) {
            const double a = 2 * kPi * (i % n) / n;
            mesh.positions.emplace_back(2 * std::sin(a), 3 * y, 2 * std::cos(a));
            mesh.uvs.emplace_back(float(i) / float(n), y);
        }
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t c : {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1}) mesh.corners.push_back(c);
        mesh.face_starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    return mesh;
}

void expect_detail_sound(const RasterGeometry& g) {
    ASSERT_EQ(g.vertices.detail.size(), g.vertices.normals.size());
    ASSERT_EQ(g.polygons.detail.size(), g.polygons.positions.size());
    for (const auto* s : {&g.vertices, &g.polygons})
        for (std::size_t i = 0; i < s->detail.size(); ++i)
            for (const glm::dvec3& gradient : {glm::dvec3(s->detail[i].u_gradient), glm::dvec3(s->detail[i].v_gradient)}) {
                ASSERT_TRUE(std::isfinite(glm::length(gradient)));
                EXPECT_LE(std::abs(glm::dot(gradient, glm::dvec3(s->normals[i].normal))), 4e-7 * glm::length(gradient));
            }
}

TEST(TessDetail, GradientsOfAFlatGridAreThoseOfItsLayout) {
    const auto turned = glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    for (const glm::dvec3& scale : {glm::dvec3(1), glm::dvec3(0.125, 4, 1), glm::dvec3(-1, 1, 1)}) {
        Scene scene = scene_of_mesh(flat_grid());
        scene.transforms[1] = turned * glm::scale(glm::dmat4(1), scale);
        const auto g = tessellate(scene, {.detail = true});
        expect_sound(g);
        expect_detail_sound(g);
        const glm::dmat3 r(turned);
        const glm::dvec3 u = r * glm::dvec3(3 / scale.x, 0, 0) / g.frame.scale,
                         v = r * glm::dvec3(1 / scale.x, 2 / scale.y, 0) / g.frame.scale;
        for (const auto* stream : {&g.vertices.detail, &g.polygons.detail})
            for (const auto& d : *stream) {
                EXPECT_LE(glm::distance(glm::dvec3(d.u_gradient), u), 1e-6 * glm::length(u));
                EXPECT_LE(glm::distance(glm::dvec3(d.v_gradient), v), 1e-6 * glm::length(v));
            }
        for (std::size_t i = 0; i < g.vertices.detail.size(); ++i) {
            const glm::dvec3 p = glm::inverse(scene.transforms[1]) *
                                 glm::dvec4(glm::dvec3(g.vertices.positions[i].position) / g.frame.scale + g.frame.origin, 1);
            EXPECT_LE(glm::distance(glm::dvec2(g.vertices.detail[i].uv), glm::dvec2(3 * p.x, 2 * p.y + p.x)), 3e-6);
        }
    }
}

TEST(TessDetail, GradientsOfATubeAreTheCylinders) {
    for (const std::uint32_t n : {8u, 32u, 128u}) {
        const auto g = tessellate(scene_of_mesh(tube(n), 3.2f), {.detail = true});
        expect_sound(g);
        expect_detail_sound(g);
        const double step = kPi / n, du = 1 / (4 * kPi) / g.frame.scale, dv = 1.0 / 3 / g.frame.scale;
        for (std::size_t i = 0; i < g.vertices.detail.size(); ++i) {
            const auto& d = g.vertices.detail[i];
            const glm::dvec3 radial = g.vertices.normals[i].normal, around = glm::cross(glm::dvec3(0, 1, 0), radial);
            // A chord is shorter than its arc by step^2 / 6, and the mean of two of them leans by step^2 / 2; at the seam by one.
            EXPECT_LE(glm::distance(glm::dvec3(d.u_gradient), du * around), (step * step + 1e-6) * du) << n;
            EXPECT_LE(glm::distance(glm::dvec3(d.v_gradient), glm::dvec3(0, dv, 0)), 1e-6 * dv);
        }
    }
}

TEST(TessDetail, VerticesThatDifferInUvAloneStaySeparate) {
    const auto g = tessellate(scene_of_mesh(tube(16), 3.2f), {.detail = true, .polygons = false});
    EXPECT_EQ(g.vertices.positions.size(), 34u) << "16 around and one more at the seam, twice";
    const auto plain = tessellate(scene_of_mesh(tube(16), 3.2f), {.polygons = false});
    EXPECT_EQ(plain.vertices.positions.size(), 32u) << "nobody asks for uv: the seam is welded";
    EXPECT_TRUE(plain.vertices.detail.empty() && plain.polygons.detail.empty());
    const auto flat = tessellate(scene_of_mesh(tube(16)), {.normals = false, .detail = true});
    EXPECT_TRUE(flat.vertices.detail.empty());
    EXPECT_EQ(flat.polygons.detail.size(), 16u);
    // Polygons beside it make the vertices go through the merge of patches.
    Scene scene = scene_of_mesh(tube(16), 3.2f);
    for (int i = 0; i < 2; ++i) scene.objects.push_back({.shape = Polygon{{{5, 0, 0}, {6, 0, 0}, {6, 1, 0}}, {}}});
    const auto merged = tessellate(scene, {.detail = true, .polygons = false});
    EXPECT_EQ(merged.vertices.positions.size(), 37u);
    expect_sound(merged, true, false);
}

TEST(TessDetail, ShapesWithoutUvGetZeros) {
    Scene scene =
        scene_of({Sphere{}, Box{{2, 0, 0}, {3, 1, 1}}, Polygon{{{5, 0, 0}, {6, 0, 0}, {6, 1, 0}}, {}}, Cylinder{{8, 0, 0}, {8, 1, 0}}});
    const auto g = tessellate(scene, {.eye = {0, 0, 20}, .detail = true});
    expect_sound(g);
    expect_detail_sound(g);
    for (const auto* stream : {&g.vertices.detail, &g.polygons.detail})
        for (const auto& d : *stream)
            EXPECT_TRUE(d.uv == glm::vec2(0) && d.u_gradient == glm::vec3(0) && d.v_gradient == glm::vec3(0) && d.pad0 == 0 && d.pad3 == 0);
}

// Two quads that meet in a line where the picture is mirrored: u = |x|.
TEST(TessDetail, MirroredHalvesDoNotCancel) {
    Mesh mesh = mesh_of({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 4, 3}, {1, 2, 5, 4}});
    mesh = with_uv(mesh, [](const glm::vec3& p) { return glm::vec2(std::abs(p.x), p.y); });
    const auto g = tessellate(scene_of_mesh(mesh), {.detail = true, .polygons = false});
    EXPECT_EQ(g.vertices.positions.size(), 8u) << "the two in the middle are doubled";
    for (std::size_t i = 0; i < g.indices.size(); i += 3) {
        double side = 0;
        for (std::size_t k = 0; k < 3; ++k) side += g.vertices.positions[g.indices[i + k]].position.x;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& d = g.vertices.detail[g.indices[i + k]];
            EXPECT_LE(glm::distance(glm::dvec3(d.u_gradient), glm::dvec3(side > 0 ? 1 : -1, 0, 0) / g.frame.scale), 1e-6);
            EXPECT_LE(glm::distance(glm::dvec3(d.v_gradient), glm::dvec3(0, 1, 0) / g.frame.scale), 1e-6);
        }
    }
}

TEST(TessDetail, UvWithoutAreaHasNoGradient) {
    for (const auto uv : {+[](const glm::vec3&) { return glm::vec2(0.1f, 0.7f); }, +[](const glm::vec3& p) { return glm::vec2(p.x / 3); },
                          +[](const glm::vec3& p) { return glm::vec2(1e7f * p.x, 0); }}) {
        const auto g = tessellate(scene_of_mesh(with_uv(grid_mesh(3, [](float, float) { return 0.0f; }), uv)), {.detail = true});
        expect_sound(g);
        for (const auto* stream : {&g.vertices.detail, &g.polygons.detail})
            for (const auto& d : *stream) EXPECT_TRUE(d.u_gradient == glm::vec3(0) && d.v_gradient == glm::vec3(0));
    }
}

TEST(TessDetail, TangentsOfTheFileLeadTheGradients) {
    Mesh mesh = flat_grid();
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    const double c = std::cos(0.5), s = std::sin(0.5);
    mesh.tangents.assign(mesh.positions.size(), glm::vec4(c, s, 0.25f, -1));
    const double u_length = 3, v_length = std::sqrt(5.0);
    for (const double mirror : {1.0, -1.0}) {
        Scene scene = scene_of_mesh(mesh);
        scene.transforms[1] = glm::scale(glm::dmat4(1), glm::dvec3(mirror, 1, 1));
        const auto g = tessellate(scene, {.subdivide = 1, .detail = true});
        expect_sound(g);
        expect_detail_sound(g);
        for (const auto& d : g.vertices.detail) {
            EXPECT_LE(glm::distance(glm::dvec3(d.u_gradient) * g.frame.scale, u_length * glm::dvec3(mirror * c, s, 0)), 2e-6);
            EXPECT_LE(glm::distance(glm::dvec3(d.v_gradient) * g.frame.scale, v_length * glm::dvec3(mirror * s, -c, 0)), 2e-6)
                << "-cross(n, t), and what a mirror makes of it";
        }
    }
    mesh.tangents.assign(mesh.positions.size(), glm::vec4(0, 0, 1, 1));
    const auto along_normal = tessellate(scene_of_mesh(mesh), {.detail = true}),
               none = tessellate(scene_of_mesh(flat_grid()), {.detail = true});
    ASSERT_EQ(along_normal.vertices.detail.size(), none.vertices.detail.size());
    for (std::size_t i = 0; i < none.vertices.detail.size(); ++i)
        EXPECT_EQ(along_normal.vertices.detail[i].u_gradient, none.vertices.detail[i].u_gradient) << "a useless tangent leaves the layout";
}

TEST(TessDetail, SubdivisionInterpolatesUv) {
    const auto g = tessellate(scene_of_mesh(flat_grid()), {.subdivide = 2, .detail = true});
    expect_sound(g);
    expect_detail_sound(g);
    EXPECT_EQ(g.polygons.positions.size(), 256u);
    for (const auto* stream : {&g.vertices, &g.polygons})
        for (std::size_t i = 0; i < stream->detail.size(); ++i) {
            const glm::dvec3 p = glm::dvec3(stream->positions[i].position) / g.frame.scale + g.frame.origin;
            EXPECT_LE(glm::distance(glm::dvec2(stream->detail[i].uv), glm::dvec2(3 * p.x, 2 * p.y + p.x)), 3e-6);
        }
    const auto once = tessellate(scene_of_mesh(tube(16), 3.2f), {.subdivide = 1, .detail = true, .polygons = false});
    EXPECT_EQ(once.vertices.positions.size(), 33u * 3) << "the seam stays one";
}

TEST(TessDetail, WithoutRequestNothingChanges) {
    Mesh plain = flat_grid();
    plain.uvs.clear();
    EXPECT_TRUE(same_bits(tessellate(scene_of_mesh(flat_grid()), {.subdivide = 1}), tessellate(scene_of_mesh(plain), {.subdivide = 1})));
    EXPECT_TRUE(
        same_bits(tessellate(scene_of_mesh(plain), {.subdivide = 1, .detail = true}), tessellate(scene_of_mesh(plain), {.subdivide = 1})));
}

} // namespace
} // namespace lightbench
