// Orders triangles by clusters, renumbers vertices by first use, and gives each triangle a first vertex that carries its polygon.
#pragma once

#include "scene/tessellate.h"

#include <array>

namespace lightbench {

// Triangles of one sidedness, in any order.
struct Soup {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> polygons; // one a triangle, or empty
};

// Replaces `vertices`, fills `indices` and `clusters`; the soups are emptied on the way.
void order_triangles(RasterGeometry& geometry, Soup& one_sided, Soup& two_sided);

} // namespace lightbench
