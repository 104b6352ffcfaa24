// Scenes of one object for the tessellation tests, and checks of its streams that share nothing with the code under test.
#pragma once

#include "scene/tessellate.h"

#include <array>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace lightbench::tess {

inline Scene scene_of(std::vector<Shape> shapes, glm::dmat4 transform = glm::dmat4(1)) {
    Scene scene;
    scene.materials.resize(1);
    scene.transforms.push_back(transform);
    for (auto& shape : shapes) scene.objects.push_back({.shape = std::move(shape), .transform = 1});
    return scene;
}

inline Scene scene_of_mesh(Mesh mesh, float crease = 0.5235988f) {
    Scene scene = scene_of({MeshUse{0}});
    scene.meshes.push_back(std::move(mesh));
    scene.objects[0].crease = crease;
    return scene;
}

inline Mesh mesh_of(std::vector<glm::vec3> positions, const std::vector<std::vector<std::uint32_t>>& faces) {
    Mesh mesh;
    mesh.positions = std::move(positions);
    mesh.face_starts = {0};
    for (const auto& face : faces) {
        mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
        mesh.face_starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    return mesh;
}

inline Mesh cube_mesh() {
    std::vector<glm::vec3> p;
    for (int i = 0; i < 8; ++i) p.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    return mesh_of(p, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

// n x n quads over [0,1]^2 at the heights f(x, y); front up (z).
template <typename F> Mesh grid_mesh(std::uint32_t n, F f) {
    std::vector<glm::vec3> p;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x)
            p.emplace_back(float(x) / float(n), float(y) / float(n), f(float(x) / float(n), float(y) / float(n)));
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x;
            faces.push_back({a, a + 1, a + n + 2, a + n + 1});
        }
    return mesh_of(p, faces);
}

struct TriangleView {
    std::array<glm::dvec3, 3> p, n;
    std::uint32_t polygon;
    glm::dvec3 cross() const { return glm::cross(p[1] - p[0], p[2] - p[0]); }
};

// Positions in world units about the frame's origin.
inline std::vector<TriangleView> triangles_of(const RasterGeometry& g) {
    std::vector<TriangleView> all;
    for (std::size_t i = 0; i + 2 < g.indices.size(); i += 3) {
        TriangleView t{};
        for (std::size_t k = 0; k < 3; ++k) {
            t.p[k] = glm::dvec3(g.vertices.positions.at(g.indices[i + k]).position) / g.frame.scale;
            if (!g.vertices.normals.empty()) t.n[k] = g.vertices.normals.at(g.indices[i + k]).normal;
        }
        t.polygon = g.vertices.positions[g.indices[i]].polygon;
        all.push_back(t);
    }
    return all;
}

inline double volume_of(const RasterGeometry& g) {
    double six = 0;
    for (const auto& t : triangles_of(g)) six += glm::dot(t.p[0], glm::cross(t.p[1], t.p[2]));
    return six / 6;
}

inline double area_of(const RasterGeometry& g) {
    double twice = 0;
    for (const auto& t : triangles_of(g)) twice += glm::length(t.cross());
    return twice / 2;
}

using Key = std::tuple<double, double, double>;
inline Key key_of(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

struct Topology {
    bool closed = true; // every edge, by the bits of its ends, is run along once each way
    long euler = 0;     // V - E + F
    std::size_t open_edges = 0;
};

inline Topology topology_of(const RasterGeometry& g) {
    std::map<std::pair<Key, Key>, int> edges;
    std::set<Key> points;
    const auto triangles = triangles_of(g);
    for (const auto& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            points.insert(key_of(t.p[k]));
            ++edges[{key_of(t.p[k]), key_of(t.p[(k + 1) % 3])}];
        }
    Topology topology;
    std::size_t undirected = 0;
    for (const auto& [edge, uses] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (uses != 1 || back == edges.end() || back->second != 1) ++topology.open_edges;
        if (back == edges.end() || edge.first < edge.second) ++undirected;
    }
    topology.closed = topology.open_edges == 0;
    topology.euler = long(points.size()) - long(undirected) + long(triangles.size());
    return topology;
}

// Every invariant that holds for any geometry: ranges, unit normals, clusters that cover all, provoking vertices of one polygon each.
inline void expect_sound(const RasterGeometry& g, bool normals = true, bool polygons = true) {
    ASSERT_EQ(g.indices.size() % 3, 0u);
    ASSERT_EQ(g.vertices.normals.size(), normals ? g.vertices.positions.size() : 0u);
    ASSERT_EQ(g.polygons.positions.size(), g.polygons.normals.size());
    ASSERT_EQ(g.polygons.positions.size(), g.polygon_objects.size());
    if (!polygons) {
        ASSERT_TRUE(g.polygons.positions.empty());
    }
    std::vector<bool> used(g.vertices.positions.size()), provoked(g.polygons.positions.size());
    for (std::uint32_t i : g.indices) {
        ASSERT_LT(i, used.size());
        used[i] = true;
    }
    for (bool u : used) EXPECT_TRUE(u) << "a vertex that no triangle uses";
    for (const auto& n : g.vertices.normals) EXPECT_NEAR(glm::length(glm::dvec3(n.normal)), 1, 2e-7);
    for (const auto& n : g.polygons.normals) EXPECT_NEAR(glm::length(glm::dvec3(n.normal)), 1, 2e-7);
    for (const auto* stream : {&g.vertices.normals, &g.polygons.normals})
        for (const auto& n : *stream) ASSERT_LT(n.material, g.surfaces.size());
    std::size_t next = 0;
    for (std::size_t c = 0; c < g.clusters.size(); ++c) {
        EXPECT_EQ(g.clusters[c].first_index, next);
        EXPECT_GT(g.clusters[c].index_count, 0u);
        EXPECT_LE(g.clusters[c].index_count, 3 * 128u);
        const std::size_t translucent = c - g.opaque_clusters;
        EXPECT_EQ(g.clusters[c].two_sided,
                  c < g.opaque_clusters ? c >= g.one_sided_clusters : translucent >= g.translucent_one_sided_clusters);
        next += g.clusters[c].index_count;
    }
    EXPECT_EQ(next, g.indices.size());
    for (std::size_t i = 0; polygons && i < g.indices.size(); i += 3) {
        const std::uint32_t polygon = g.vertices.positions[g.indices[i]].polygon;
        ASSERT_LT(polygon, provoked.size());
        provoked[polygon] = true;
    }
    for (bool p : provoked) EXPECT_TRUE(p) << "a polygon without a triangle";
    for (std::size_t i = 0; i < g.polygons.positions.size(); ++i) EXPECT_EQ(g.polygons.positions[i].polygon, i);
}

// For scenes of planar polygons: each triangle lies in the plane of the polygon that its first vertex names, and faces as it does.
inline void expect_provoked_in_plane(const RasterGeometry& g, double tolerance = 1e-5) {
    for (const auto& t : triangles_of(g)) {
        const glm::dvec3 normal = g.polygons.normals[t.polygon].normal;
        const glm::dvec3 center = glm::dvec3(g.polygons.positions[t.polygon].position) / g.frame.scale;
        const double size = glm::length(t.p[1] - t.p[0]) + glm::length(t.p[2] - t.p[0]) + glm::length(t.p[0] - center);
        for (const auto& p : t.p) EXPECT_LE(std::abs(glm::dot(p - center, normal)), tolerance * size + 2e-7 / g.frame.scale);
        EXPECT_GE(glm::dot(t.cross(), normal), 0);
    }
}

inline bool same_bits(const RasterGeometry& a, const RasterGeometry& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
    };
    const auto clusters = [](const Cluster& c) {
        return std::tuple(c.first_index, c.index_count, c.center.x, c.center.y, c.center.z, c.radius, c.cone_axis.x, c.cone_axis.y,
                          c.cone_axis.z, c.cone_cutoff, c.two_sided);
    };
    if (a.clusters.size() != b.clusters.size()) return false;
    for (std::size_t i = 0; i < a.clusters.size(); ++i)
        if (clusters(a.clusters[i]) != clusters(b.clusters[i])) return false;
    return same(a.vertices.positions, b.vertices.positions) && same(a.vertices.normals, b.vertices.normals) && same(a.indices, b.indices) &&
           same(a.polygons.positions, b.polygons.positions) && same(a.polygons.normals, b.polygons.normals) &&
           same(a.polygon_objects, b.polygon_objects) && a.frame.radius == b.frame.radius;
}

} // namespace lightbench::tess
