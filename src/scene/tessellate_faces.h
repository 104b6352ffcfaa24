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

// What a file says of a corner's place in its pictures.
struct TexturePoint {
    glm::dvec2 uv{0};
    glm::dvec4 tangent{0}; // the way of u, world axes, any length (0: not given); w the sign of the way of v
};

struct Faces {
    glm::dvec3 anchor{0};                 // world, relative to the frame's origin: where the points' zero is
    std::vector<glm::dvec3> points;       // world axes, metres
    std::vector<glm::dvec3> normals;      // unit
    std::vector<Corner> corners;          // loops, counter-clockwise seen from outside
    std::vector<std::uint32_t> starts{0}; // faces + 1
    std::vector<std::uint32_t> materials; // empty, or one a face
    std::vector<Corner> hubs;             // empty, or one a face: the point inside that its triangles meet in; point kNone: no hub
    std::vector<TexturePoint> texture_points;
    std::vector<std::uint32_t> corner_textures; // empty, or one a corner: index into texture_points

    std::size_t count() const { return starts.size() - 1; }
    std::span<const Corner> loop(std::size_t face) const { return {corners.data() + starts[face], starts[face + 1] - starts[face]}; }
    std::span<Corner> loop(std::size_t face) { return {corners.data() + starts[face], starts[face + 1] - starts[face]}; }
    std::span<const std::uint32_t> textures(std::size_t face) const {
        return corner_textures.empty() ? std::span<const std::uint32_t>()
                                       : std::span(&corner_textures[starts[face]], starts[face + 1] - starts[face]);
    }
    void close_face() { starts.push_back(static_cast<std::uint32_t>(corners.size())); }
};

// Where a point lies in the pictures of a surface, and how that changes along the surface.
struct Detail {
    glm::dvec2 uv{0};
    glm::dvec3 u_gradient{0}, v_gradient{0}; // per metre, world axes
};

// The details of faces with texture points.
struct Details {
    std::vector<Detail> of_faces;          // one a face
    std::vector<Detail> of_vertices;       // each of some corners that agree in all there is
    std::vector<std::uint32_t> of_corners; // index into of_vertices
};

// What the streams are filled from: vertices are what differs in point, normal, detail or material.
struct Facets {
    glm::dvec3 anchor{0};
    std::vector<glm::dvec3> positions, normals;  // one a vertex; normals may be empty
    std::vector<std::uint32_t> vertex_materials; // empty, or one a vertex
    std::vector<Detail> details;                 // empty, or one a vertex
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> triangle_faces; // one a triangle
    std::vector<glm::dvec3> face_centers, face_normals;
    std::vector<std::uint32_t> face_materials; // empty, or one a face
    std::vector<Detail> face_details;          // empty, or one a face
};

} // namespace lightbench
