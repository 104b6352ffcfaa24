// One closed bumpy body as a single mesh of any size: a cube of k x k quads a side, blown up to a sphere and rippled. In: about how many
// triangles. Out: 6 k^2 + 2 vertices, all shared, and exactly 12 k^2 triangles; no normals, so that the reader averages them.
#include "scene/make_kinds.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

// Numbers the surface points of the grid {0..k}^3 row by row: first the bottom layer, then the rings of the middle layers, then the top.
struct CubeGrid {
    std::uint32_t k;
    std::uint32_t layer() const { return (k + 1) * (k + 1); }
    std::uint32_t ring() const { return 4 * k; }
    std::uint32_t count() const { return 6 * k * k + 2; }
    std::uint32_t at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
        if (y == 0) return z * (k + 1) + x;
        const std::uint32_t base = layer() + (y - 1) * ring();
        if (y == k) return base + z * (k + 1) + x;
        if (z == 0) return base + x;
        if (x == k) return base + k + z;
        if (z == k) return base + 3 * k - x;
        return base + 4 * k - z;
    }
};

// The radius along the unit vector d: a product of sines, smooth, without poles or seams.
double radius_towards(const glm::dvec3& d, double bumps) {
    return 1 + 0.06 * std::sin(bumps * d.x) * std::sin(bumps * d.y + 1) * std::sin(bumps * d.z + 2) +
           0.03 * std::sin(2 * bumps * (d.x + d.y - d.z));
}

void place(Mesh& mesh, const CubeGrid& grid, double bumps, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    // Equal angles instead of equal steps: quads near a corner of the cube come out as large as those in the middle of a side.
    const auto even = [&](std::uint32_t i) { return std::tan((2.0 * i / grid.k - 1) * (std::numbers::pi / 4)); };
    const glm::dvec3 d = glm::normalize(glm::dvec3(even(x), even(y), even(z)));
    mesh.positions[grid.at(x, y, z)] = radius_towards(d, bumps) * d;
}

void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    for (const std::uint32_t v : {a, b, c}) mesh.corners.push_back(v);
    mesh.face_starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    for (const std::uint32_t v : {a, c, d}) mesh.corners.push_back(v);
    mesh.face_starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
}

} // namespace

Scene make_mesh(const MakeValues& values) {
    Scene scene;
    const CubeGrid grid{static_cast<std::uint32_t>(std::max(1.0, std::round(std::sqrt(values["triangles"] / 12))))};
    const std::uint32_t k = grid.k;
    Mesh mesh;
    mesh.name = "body";
    mesh.positions.resize(grid.count());
    mesh.corners.reserve(std::size_t{36} * k * k);
    mesh.face_starts.reserve(std::size_t{12} * k * k + 1);
    mesh.face_starts.push_back(0);
    for (std::uint32_t i = 0; i <= k; ++i)
        for (std::uint32_t j = 0; j <= k;
             ++j) // a point on an edge of the cube belongs to two or three sides and gets the same place each time
            for (const std::uint32_t side : {0u, k}) {
                place(mesh, grid, values["bumps"], side, i, j);
                place(mesh, grid, values["bumps"], i, side, j);
                place(mesh, grid, values["bumps"], i, j, side);
            }
    for (std::uint32_t i = 0; i < k; ++i)
        for (std::uint32_t j = 0; j < k; ++j) {
            add_quad(mesh, grid.at(0, i, j), grid.at(0, i, j + 1), grid.at(0, i + 1, j + 1), grid.at(0, i + 1, j));
            add_quad(mesh, grid.at(k, i, j), grid.at(k, i + 1, j), grid.at(k, i + 1, j + 1), grid.at(k, i, j + 1));
            add_quad(mesh, grid.at(i, 0, j), grid.at(i + 1, 0, j), grid.at(i + 1, 0, j + 1), grid.at(i, 0, j + 1));
            add_quad(mesh, grid.at(i, k, j), grid.at(i, k, j + 1), grid.at(i + 1, k, j + 1), grid.at(i + 1, k, j));
            add_quad(mesh, grid.at(i, j, 0), grid.at(i, j + 1, 0), grid.at(i + 1, j + 1, 0), grid.at(i + 1, j, 0));
            add_quad(mesh, grid.at(i, j, k), grid.at(i + 1, j, k), grid.at(i + 1, j + 1, k), grid.at(i, j + 1, k));
        }
    add_mesh(scene, std::move(mesh), add_glossy(scene, "stone", {0.6f, 0.55f, 0.5f}, 0.3f, 30));
    add_camera(scene, {1.2, 1, 3.4}, glm::dvec3(0), 38);
    add_point_light(scene, {3, 3.5, 3}, glm::vec3(4.5f, 4.3f, 4));
    add_directional_light(scene, {1, -0.2, -0.6}, {0.1f, 0.13f, 0.2f});
    scene.environment.ambient = glm::vec3(0.08f);
    return scene;
}

} // namespace lightbench
