// PatchMeshes of rectangles, for tests and benchmarks of hemi-cubes: no scene needed.
#pragma once

#include "radiosity/patches.h"

#include <algorithm>

namespace lightbench {

// Elements columns x rows over corner + [0, 1] u + [0, 1] v, in patches of `along` x `along` elements; it faces the way of cross(u, v).
struct PatchGrid {
    glm::dvec3 corner{0}, u{1, 0, 0}, v{0, 1, 0};
    unsigned columns = 1, rows = 1, along = 1;
};

// Numbers of what was added.
struct AddedGrid {
    std::uint32_t first_element = 0, elements = 0, first_patch = 0, patches = 0;
};

inline void add_element(PatchMesh& mesh, const PatchGrid& g, std::uint32_t first_point, unsigned i, unsigned j) {
    Element e;
    const std::uint32_t a = first_point + j * (g.columns + 1) + i, b = a + g.columns + 1;
    e.corners = {a, a + 1, b + 1, b};
    e.patch = static_cast<std::uint32_t>(mesh.patches.size());
    e.center = g.corner + g.u * ((i + 0.5) / g.columns) + g.v * ((j + 0.5) / g.rows);
    const glm::dvec3 across = glm::cross(g.u, g.v);
    e.normal = glm::normalize(across), e.area = glm::length(across) / (g.columns * g.rows);
    mesh.elements.push_back(e);
}

inline AddedGrid add_grid(PatchMesh& mesh, const PatchGrid& g) {
    AddedGrid added{static_cast<std::uint32_t>(mesh.elements.size()), g.columns * g.rows, static_cast<std::uint32_t>(mesh.patches.size()),
                    0};
    const auto first_point = static_cast<std::uint32_t>(mesh.points.size());
    for (unsigned j = 0; j <= g.rows; ++j)
        for (unsigned i = 0; i <= g.columns; ++i)
            mesh.points.push_back(g.corner + g.u * (double(i) / g.columns) + g.v * (double(j) / g.rows));
    for (unsigned y = 0; y < g.rows; y += g.along)
        for (unsigned x = 0; x < g.columns; x += g.along) {
            const unsigned x1 = std::min(x + g.along, g.columns), y1 = std::min(y + g.along, g.rows);
            Patch patch;
            patch.first = static_cast<std::uint32_t>(mesh.elements.size()), patch.count = (x1 - x) * (y1 - y);
            for (unsigned j = y; j < y1; ++j)
                for (unsigned i = x; i < x1; ++i) add_element(mesh, g, first_point, i, j);
            const glm::dvec3 across = glm::cross(g.u, g.v), du = g.u * (double(x1 - x) / g.columns), dv = g.v * (double(y1 - y) / g.rows);
            patch.center = g.corner + g.u * (0.5 * (x + x1) / g.columns) + g.v * (0.5 * (y + y1) / g.rows);
            patch.normal = glm::normalize(across), patch.area = glm::length(glm::cross(du, dv));
            patch.radius = 0.5 * std::max(glm::length(du + dv), glm::length(du - dv));
            mesh.patches.push_back(patch);
        }
    added.patches = static_cast<std::uint32_t>(mesh.patches.size()) - added.first_patch;
    return added;
}

// The cube [-1, 1]^3 seen from inside; `n` elements along an edge.
inline PatchMesh closed_box(unsigned n, unsigned along) {
    PatchMesh mesh;
    const glm::dvec3 x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
    for (const auto& [corner, u, v] :
         {std::array{glm::dvec3(-1, -1, -1), x, y}, std::array{glm::dvec3(-1, -1, 1), y, x}, std::array{glm::dvec3(-1, -1, -1), y, z},
          std::array{glm::dvec3(1, -1, -1), z, y}, std::array{glm::dvec3(-1, -1, -1), z, x}, std::array{glm::dvec3(-1, 1, -1), x, z}})
        add_grid(mesh, {corner, u, v, n, n, along});
    return mesh;
}

} // namespace lightbench
