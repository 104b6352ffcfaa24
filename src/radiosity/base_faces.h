// The faces of all objects of a scene, welded into one, before they are cut into elements. In: Scene, how long an edge of a curved
// primitive's facet may be. Out: BaseMesh, its edges, which faces hang together smoothly. Pure.
#pragma once

#include "scene/tessellate.h"
#include "scene/tessellate_faces.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lightbench {

// How many pieces of length at most `most` it takes. A length that rounding made a hair longer (2^-40 of it, thousands of ulp) is not cut
// once more for that.
double pieces_of(double length, double most);

// A planar face, or nearly: its normal is Newell's.
struct BaseFace {
    std::uint32_t first = 0, count = 0; // into BaseMesh::corners
    std::uint32_t surface = 0, object = 0;
    std::uint32_t hub = kNone; // the point inside that its triangles meet in, if it has one
    float crease = 0;          // radians, its object's
    bool two_sided = false;
    glm::dvec3 normal{0}; // unit
};

struct BaseMesh {
    Frame frame;
    std::vector<glm::dvec3> points; // frame; equal ones are one, whatever objects they belong to
    std::vector<glm::dvec3> normals;
    std::vector<Corner> corners;
    std::vector<BaseFace> faces;
    std::vector<Surface> surfaces;
    std::size_t dropped = 0; // faces without area
    std::span<const Corner> loop(const BaseFace& face) const { return {corners.data() + face.first, face.count}; }
};

// `facet` in frame units. Throws std::length_error if curved primitives alone would come to more than limits::kMaxElements.
BaseMesh base_faces(const Scene& scene, const Frame& frame, double facet);

// Edge e joins points ends[e][0] < ends[e][1]; the corners that it starts at, whichever way, are users[starts[e]] ... users[starts[e + 1] -
// 1].
struct BaseEdges {
    std::vector<std::array<std::uint32_t, 2>> ends;
    std::vector<std::uint32_t> starts, users;
    std::vector<std::uint32_t> of_corner;      // the edge from a corner to the next of its face
    std::vector<std::uint32_t> face_of_corner; // index into BaseMesh::faces
    std::size_t count() const { return ends.size(); }
    std::span<const std::uint32_t> users_of(std::uint32_t e) const { return {users.data() + starts[e], starts[e + 1] - starts[e]}; }
};
BaseEdges edges_of(const BaseMesh& base);

// Index of a corner's successor in its face.
std::uint32_t next_corner(const BaseMesh& base, const BaseEdges& edges, std::uint32_t corner);

// A number a face: equal where one can walk from face to face of one surface over edges that are not sharp. An edge is smooth if the faces
// of an object share a normal at one of its ends at least (their own normals, or what smoothing up to the crease angle made), and those of
// two objects if they meet at less than the crease angle. An edge that more than two faces share is sharp.
std::vector<std::uint32_t> smooth_groups(const BaseMesh& base, const BaseEdges& edges);

// Two triangles of a group that together are nearly a rectangle become one face. Edges and groups are to be found anew.
void pair_triangles(BaseMesh& base, const BaseEdges& edges, const std::vector<std::uint32_t>& groups);

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i);

} // namespace lightbench
