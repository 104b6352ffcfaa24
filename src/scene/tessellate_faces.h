// The faces of one object while they are cut: points and normals by index, so that neighbours share what is equal bit by bit.
// Handed from the shapes (primitive_meshes.h, tessellate_mesh.h) through normals and subdivision to the triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lightbench {

constexpr std::uint32_t kNone = 0xffffffffu;

struct Corner {
    std::uint32_t point = 0, normal = kNone;
    bool operator==(const Corner&) const = default;
};

struct Faces {
    glm::dvec3 anchor{0};                 // world, relative to the frame's origin: where the points' zero is
    std::vector<glm::dvec3> points;       // world axes, metres
    std::vector<glm::dvec3> normals;      // unit
    std::vector<Corner> corners;          // loops, counter-clockwise seen from outside
    std::vector<std::uint32_t> starts{0}; // faces + 1
    std::vector<std::uint32_t> materials; // empty, or one a face
    std::vector<Corner> hubs;             // empty, or one a face: the point inside that its triangles meet in; point kNone: no hub

    std::size_t count() const { return starts.size() - 1; }
    std::span<const Corner> loop(std::size_t face) const { return {corners.data() + starts[face], starts[face + 1] - starts[face]}; }
    std::span<Corner> loop(std::size_t face) { return {corners.data() + starts[face], starts[face + 1] - starts[face]}; }
    void close_face() { starts.push_back(static_cast<std::uint32_t>(corners.size())); }
};

// What the streams are filled from: vertices are what differs in point, normal or material.
struct Facets {
    glm::dvec3 anchor{0};
    std::vector<glm::dvec3> positions, normals;  // one a vertex; normals may be empty
    std::vector<std::uint32_t> vertex_materials; // empty, or one a vertex
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> triangle_faces; // one a triangle
    std::vector<glm::dvec3> face_centers, face_normals;
    std::vector<std::uint32_t> face_materials; // empty, or one a face
};

} // namespace lightbench
