// Orders triangles by clusters, renumbers vertices by first use, and gives each triangle a first vertex that carries its polygon.
#pragma once

#include "scene/tessellate.h"

#include <array>

namespace lightbench {

// Triangles of one sidedness and opacity, in any order.
struct Soup {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> polygons; // one a triangle, or empty
};

// In the order of the clusters: opaque one-sided, opaque two-sided, translucent one-sided, translucent two-sided.
using Soups = std::array<Soup, 4>;
constexpr std::size_t soup_of(bool translucent, bool two_sided) {
    return 2 * std::size_t{translucent} + std::size_t{two_sided};
}

// Replaces `vertices`, fills `indices` and `clusters`; the soups are emptied on the way.
void order_triangles(RasterGeometry& geometry, Soups& soups);

} // namespace lightbench
