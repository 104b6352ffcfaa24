// Procedural scenes of published coordinates, and the geometry that makes each failure of shading happen.
#include "scene/limits.h"
#include "unit/make_support.h"

#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <numbers>
#include <set>

using namespace lightbench;
using namespace lightbench::make_test;

// The corners as Cornell publishes them (metric data of the box, millimetres).
TEST(Make, CornellBoxIsThePublishedOne) {
    const std::vector<std::vector<glm::dvec3>> published = {
        {{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}},
        {{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}},
        {{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}},
        {{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}},
        {{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}},
        {{290, 0, 114}, {290, 165, 114}, {240, 165, 272}, {240, 0, 272}},
        {{130, 0, 65}, {130, 165, 65}, {290, 165, 114}, {290, 0, 114}},
        {{82, 0, 225}, {82, 165, 225}, {130, 165, 65}, {130, 0, 65}},
        {{240, 0, 272}, {240, 165, 272}, {82, 165, 225}, {82, 0, 225}},
        {{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}},
        {{423, 0, 247}, {423, 330, 247}, {472, 330, 406}, {472, 0, 406}},
        {{472, 0, 406}, {472, 330, 406}, {314, 330, 456}, {314, 0, 456}},
        {{314, 0, 456}, {314, 330, 456}, {265, 330, 296}, {265, 0, 296}},
        {{265, 0, 296}, {265, 330, 296}, {423, 330, 247}, {423, 0, 247}},
        {{343, 548.7, 227}, {343, 548.7, 332}, {213, 548.7, 332}, {213, 548.7, 227}},
        {{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}},
        {{552.8, 0, 0}, {556, 548.8, 559.2}, {556, 548.8, 0}},
    };
    const Scene scene = made("cornell-box");
    const auto polygons = shapes<Polygon>(scene);
    ASSERT_EQ(polygons.size(), published.size());
    // The same corners in the same turn, whichever comes first.
    const auto same = [](const std::vector<glm::dvec3>& a, std::vector<glm::dvec3> b) {
        for (std::size_t i = 0; i < b.size(); ++i, std::rotate(b.begin(), b.begin() + 1, b.end()))
            if (a == b) return true;
        return false;
    };
    for (const auto& quad : published)
        EXPECT_EQ(std::count_if(polygons.begin(), polygons.end(), [&](const Polygon& p) { return same(quad, p.points); }), 1)
            << quad[0].x << " " << quad[0].y << " " << quad[0].z;
    EXPECT_NEAR(scene.cameras[0].fov, 39.307648 * std::numbers::pi / 180, 1e-8);
    EXPECT_EQ(scene.cameras[0].position, glm::dvec3(278, 273, -800));
    EXPECT_EQ(made("cornell-box", {{"point_light", "0"}}).lights.size(), 0u);
}

// Walls and lamp face into the box, the sides of a block away from its middle.
TEST(Make, CornellBoxFacesItsInside) {
    const auto polygons = shapes<Polygon>(made("cornell-box"));
    const auto faces = [&](std::size_t i, const glm::dvec3& p) {
        return glm::dot(newell(polygons.at(i).points), p - polygons[i].points[0]) > 0;
    };
    for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(faces(i, {278, 400, 280})) << "wall " << i;
    for (std::size_t i = 6; i < 11; ++i) EXPECT_FALSE(faces(i, {185, 80, 169})) << "short block, side " << i;
    for (std::size_t i = 11; i < 16; ++i) EXPECT_FALSE(faces(i, {368, 160, 351})) << "tall block, side " << i;
    EXPECT_TRUE(faces(16, {278, 400, 280})) << "lamp";
}

TEST(Make, CorrugatedNormalsAreParallelUnlessCut) {
    const Scene flat = made("corrugated", {{"ridges", "9"}, {"slope", "35"}});
    const auto n = averaged_normals(flat.meshes.at(0));
    ASSERT_EQ(n.size(), 2u * (2 * 9 + 1));
    for (std::size_t i = 2; i + 2 < n.size(); ++i) EXPECT_LT(glm::distance(n[i], glm::dvec3(0, 1, 0)), 1e-6) << i;
    for (std::size_t f = 0; f < flat.meshes[0].face_count(); ++f)
        EXPECT_NEAR(glm::normalize(newell(face_points(flat.meshes[0], f))).y, std::cos(35 * std::numbers::pi / 180), 1e-6);
    EXPECT_GT(flat.objects.at(0).crease, 70 * std::numbers::pi / 180) << "a crease angle below the edges would hide the failure";
    const auto cut = averaged_normals(made("corrugated", {{"ridges", "9"}, {"slope", "35"}, {"subdivide", "2"}}).meshes.at(0));
    double least = 1;
    for (const glm::dvec3& v : cut) least = std::min(least, v.y);
    EXPECT_LT(least, 0.83); // cos 35 degrees is 0.819
}

// R.V^n by hand: full in the middle, nothing at the vertices.
TEST(Make, HighlightIsInTheMiddleAndNowhereElse) {
    const Scene scene = made("highlight");
    const auto points = shapes<Polygon>(scene).at(0).points;
    const auto highlight = [&](const glm::dvec3& p) {
        const glm::dvec3 n(0, 1, 0), l = glm::normalize(scene.lights[0].position - p), v = glm::normalize(scene.cameras[0].position - p);
        return std::pow(std::max(0.0, glm::dot(2 * glm::dot(n, l) * n - l, v)), static_cast<double>(scene.materials[0].shininess));
    };
    EXPECT_GT(highlight((points[0] + points[1] + points[2]) / 3.0), 0.999);
    for (const glm::dvec3& p : points) EXPECT_LT(highlight(p), 1e-3);
}

TEST(Make, CreaseBodiesAreClosedAndFaceOutwards) {
    for (const Mesh& m : made("crease").meshes) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        double volume = 0; // sixfold
        for (std::size_t f = 0; f < m.face_count(); ++f) {
            const auto p = face_points(m, f);
            for (std::size_t i = 1; i + 1 < p.size(); ++i) volume += glm::dot(p[0], glm::cross(p[i], p[i + 1]));
            for (std::uint32_t c = m.face_starts[f]; c < m.face_starts[f + 1]; ++c)
                ++edges[{m.corners[c], m.corners[c + 1 == m.face_starts[f + 1] ? m.face_starts[f] : c + 1]}];
        }
        EXPECT_GT(volume, 0) << m.name;
        for (const auto& [edge, uses] : edges) {
            EXPECT_EQ(uses, 1) << m.name;
            EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << m.name << ": an open edge";
        }
    }
}

// The intensity of a vertex is the cosine of its normal's tilt: the bars of the third body carry what lies on the outline.
TEST(Make, ScanLinesOfAQuadFollowItsOutline) {
    for (const double turn : {0.0, 30.0, 45.0}) {
        const Scene scene = made("quads", {{"turn", std::to_string(turn)}});
        ASSERT_EQ(scene.meshes.size(), 3u);
        const Mesh& split = scene.meshes[0];
        const Mesh& bars = scene.meshes[2];
        ASSERT_EQ(split.face_count(), 2u);
        for (std::size_t v = 0; v + 3 < bars.positions.size(); v += 4) {
            const glm::dvec2 left = 0.5 * (glm::dvec2(bars.positions[v]) + glm::dvec2(bars.positions[v + 3])) - glm::dvec2(3.2, 0);
            double nearest = 1e9, intensity = 0;
            for (std::size_t e = 0; e < 4; ++e) { // the edge of the outline that the end lies on
                const std::size_t a = e, b = (e + 1) % 4;
                const glm::dvec2 p = glm::dvec2(split.positions[a]) + glm::dvec2(3.2, 0),
                                 d = glm::dvec2(split.positions[b]) + glm::dvec2(3.2, 0) - p;
                const double u = glm::dot(left - p, d) / glm::dot(d, d), away = glm::distance(left, p + u * d);
                if (u < 0 || u > 1 || away > nearest) continue;
                nearest = away, intensity = glm::mix(double(split.normals[a].z), double(split.normals[b].z), u);
            }
            EXPECT_LT(nearest, 1e-6) << turn << ": bar " << v / 4;
            EXPECT_NEAR(bars.normals[v].z, intensity, 1e-6) << turn << ": bar " << v / 4;
        }
    }
}

TEST(Make, MeshIsClosedOutwardsAndOfTheSizeAsked) {
    for (const std::size_t k : {1u, 2u, 7u}) {
        const Mesh m = made("mesh", {{"triangles", std::to_string(12 * k * k)}}).meshes.at(0);
        EXPECT_EQ(m.face_count(), 12 * k * k);
        EXPECT_EQ(m.positions.size(), 6 * k * k + 2);
        EXPECT_EQ(std::set<std::uint32_t>(m.corners.begin(), m.corners.end()).size(), m.positions.size());
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (std::size_t f = 0; f < m.face_count(); ++f) {
            const std::uint32_t* c = &m.corners[3 * f];
            for (int i = 0; i < 3; ++i) EXPECT_TRUE(edges.insert({c[i], c[(i + 1) % 3]}).second);
            const auto p = face_points(m, f);
            EXPECT_GT(glm::dot(newell(p), p[0] + p[1] + p[2]), 0) << "face " << f << " looks inwards";
        }
        for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1u);
    }
    EXPECT_EQ(made("mesh").meshes.at(0).face_count(), 1'002'252u); // 12 * 289^2, the nearest to a million
}
