// Which faces become grids and which triangles. What the header of the same name says.
#include "radiosity/cut.h"

#include "scene/limits.h"
#include "scene/triangulate.h"

#include <fmt/format.h>
#include <stdexcept>

namespace lightbench {
namespace {

bool is_convex_quadrilateral(const BaseMesh& base, const BaseFace& face) {
    if (face.count != 4 || face.hub != kNone) return false;
    std::array<glm::dvec3, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = base.points[base.loop(face)[i].point];
    return strictly_convex(flatten(points, face.normal));
}

} // namespace

void count_sides(Cutting& cutting, double more) {
    const double sides = double(cutting.sides) + more;
    if (sides > double(limits::kMaxElements))
        throw std::length_error(
            fmt::format("the scene comes to {:.0f} elements and more; kMaxElements is {}: ask for larger ones, or draw less", sides,
                        limits::kMaxElements));
    cutting.sides = static_cast<std::size_t>(sides);
}

Cutting cut(const BaseMesh& base, const BaseEdges& edges, const CutSizes& sizes) {
    Cutting cutting;
    cutting.points = base.points;
    std::vector<bool> grid(base.faces.size());
    for (std::size_t f = 0; f < grid.size(); ++f) grid[f] = is_convex_quadrilateral(base, base.faces[f]);
    cut_grids(base, edges, sizes, grid, cutting);
    cut_triangles(base, sizes, grid, cutting);
    return cutting;
}

} // namespace lightbench
