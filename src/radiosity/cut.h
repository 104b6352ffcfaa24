// Faces cut into quadrilaterals and triangles that meet corner to corner. In: BaseMesh, its edges, sizes. Out: Cutting. Pure.
#pragma once

#include "radiosity/base_faces.h"

namespace lightbench {

struct CutSizes {
    double element = 1, patch = 1; // frame units
};

struct Piece {
    std::array<std::uint32_t, 4> corners; // index into Cutting::points; [3] is kNone for a triangle
    std::uint32_t face = 0;               // index into BaseMesh::faces
    std::uint32_t unit = 0;
    std::size_t size() const { return corners[3] == kNone ? 3 : 4; }
};

// Pieces of one face that are near each other: a patch, or a part of one.
struct Unit {
    std::uint32_t face = 0;
};

struct Cutting {
    std::vector<glm::dvec3> points; // frame; those of the faces first
    std::vector<Piece> pieces;
    std::vector<Unit> units;
    std::size_t sides = 0; // pieces, those of faces with two sides counted twice
};

// Throws std::length_error if there would be more than limits::kMaxElements sides.
Cutting cut(const BaseMesh& base, const BaseEdges& edges, const CutSizes& sizes);

// Its two halves. `grid` says of each face which of them cuts it; each appends to `cutting`.
// Grids: all edges that face each other across a row of quadrilaterals get the same number of pieces. Takes faces out of `grid` whose
// neighbours of the other kind could not follow.
void cut_grids(const BaseMesh& base, const BaseEdges& edges, const CutSizes& sizes, std::vector<bool>& grid, Cutting& cutting);
// Triangles: the longest edge of all is halved, and every triangle at it, until none is longer than an element.
void cut_triangles(const BaseMesh& base, const CutSizes& sizes, const std::vector<bool>& grid, Cutting& cutting);

// Adds sides, and throws if there are too many.
void count_sides(Cutting& cutting, double more);

} // namespace lightbench
