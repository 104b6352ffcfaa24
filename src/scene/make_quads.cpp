// One quad, four intensities, three interpolations (S8): split along either diagonal, as triangles are, and along scan lines, as Gouraud
// (1971) did. Made for Gouraud shading: a vertex's normal is tilted until the light gives it the intensity that the quad has there.
#include "scene/make_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lightbench {
namespace {

constexpr std::array kIntensities{0.95, 0.05, 0.95, 0.05}; // at the corners, counter-clockwise
constexpr std::uint32_t kScanLines = 96;

struct Corner {
    glm::dvec2 at;
    double intensity;
};
using Quad = std::array<Corner, 4>;

// A square of side 2 about the origin, turned.
Quad turned_quad(double angle) {
    const glm::dvec2 u(std::cos(angle), std::sin(angle)), v(-u.y, u.x);
    return {{{-u - v, kIntensities[0]}, {u - v, kIntensities[1]}, {u + v, kIntensities[2]}, {v - u, kIntensities[3]}}};
}

// Light along -z on a white surface: the intensity is the cosine of the tilt.
std::uint32_t add_lit_vertex(Mesh& mesh, glm::dvec2 at, double intensity) {
    mesh.positions.emplace_back(at, 0);
    mesh.normals.emplace_back(std::sqrt(1 - intensity * intensity), 0, intensity);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

Mesh split_quad(const Quad& quad, std::uint32_t first) {
    Mesh mesh;
    mesh.name = first == 0 ? "bright-diagonal" : "dark-diagonal";
    for (const Corner& c : quad) add_lit_vertex(mesh, c.at, c.intensity);
    add_face(mesh, {first, first + 1, first + 2});
    add_face(mesh, {first + 2, (first + 3) % 4, first});
    return mesh;
}

// Where the line at height y cuts the outline, from left to right, each with the intensity interpolated along its edge: I_Q and I_R of S8.
std::array<Corner, 2> cut(const Quad& quad, double y) {
    std::array<Corner, 2> ends{{{{1e9, y}, 0}, {{-1e9, y}, 0}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Corner &a = quad[i], &b = quad[(i + 1) % 4];
        if ((a.at.y < y) == (b.at.y < y)) continue;
        const double u = (y - a.at.y) / (b.at.y - a.at.y), x = a.at.x + u * (b.at.x - a.at.x);
        const Corner crossing{{x, y}, a.intensity + u * (b.intensity - a.intensity)};
        if (x < ends[0].at.x) ends[0] = crossing;
        if (x > ends[1].at.x) ends[1] = crossing;
    }
    return ends;
}

// Each scan line as a bar of constant height between its two ends: the interpolation along it is the device's.
Mesh scan_line_quad(const Quad& quad) {
    Mesh mesh;
    mesh.name = "scan-lines";
    const auto [low, high] = std::ranges::minmax(quad, {}, [](const Corner& c) { return c.at.y; });
    const double step = (high.at.y - low.at.y) / kScanLines;
    for (std::uint32_t line = 0; line < kScanLines; ++line) {
        const double y = low.at.y + (line + 0.5) * step;
        const auto [left, right] = cut(quad, y);
        const glm::dvec2 half(0, step / 2);
        const auto first = add_lit_vertex(mesh, left.at - half, left.intensity);
        add_lit_vertex(mesh, right.at - half, right.intensity);
        add_lit_vertex(mesh, right.at + half, right.intensity);
        add_lit_vertex(mesh, left.at + half, left.intensity);
        add_face(mesh, {first, first + 1, first + 2, first + 3});
    }
    return mesh;
}

} // namespace

Scene make_quads(const MakeValues& values) {
    Scene scene;
    const std::uint32_t white = add_diffuse(scene, "white", glm::vec3(1));
    const Quad quad = turned_quad(radians_of(values["turn"]));
    double x = -3.2;
    for (Mesh mesh : {split_quad(quad, 0), split_quad(quad, 1), scan_line_quad(quad)}) {
        for (auto& p : mesh.positions) p.x += x;
        add_mesh(scene, std::move(mesh), white);
        x += 3.2;
    }
    add_directional_light(scene, {0, 0, -1}, glm::vec3(1));
    add_camera(scene, {0, 0, 10}, {0, 0, 0}, 33);
    scene.environment.background = {0.02f, 0.025f, 0.035f};
    return scene;
}

} // namespace lightbench
