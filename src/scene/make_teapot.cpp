// Newell's teapot: curves that turn about the pot's axis, and tubes for handle and spout. In: pieces a patch. Out: one mesh, chrome.
// The numbers are those of M. Newell 1975, "The Utilization of Procedure Models in Digital Image Synthesis", as F. Crow 1987, "The Origins of
// the Teapot", prints them: 32 patches, of which the symmetry of the pot leaves 10 curves and strips. Up is +Y here, and units are his.
#include "scene/make_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lightbench {
namespace {

using Curve = std::array<glm::dvec2, 4>; // control points (distance from the axis, height)

// From the knob down to the lid's rim; from the pot's rim down to the middle of its bottom.
constexpr std::size_t kLidCurves = 2, kPotCurves = 4;
constexpr std::array<std::array<std::array<double, 2>, 4>, kLidCurves> kLid = {
    {{{{0, 3.15}, {0.8, 3.15}, {0, 2.85}, {0.2, 2.7}}}, {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}}}};
constexpr std::array<std::array<std::array<double, 2>, 4>, kPotCurves> kPot = {
    {{{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}},
     {{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}},
     {{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}},
     {{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0}, {0, 0}}}}};
// A quarter of a circle, nearly: control points (1, 0), (1, k), (k, 1), (0, 1).
constexpr double kQuarter = 0.56;

// A tube's outline at one control row: its points in the pot's plane of symmetry, nearer to the pot's inside and farther, and how wide it is.
struct Outline {
    double inner_x, inner_height, outer_x, outer_height, half_width;
};
using Tube = std::array<Outline, 7>; // two patches that share the middle row
constexpr Tube kHandle = {{{-1.6, 2.025, -1.5, 2.25, 0.3},
                           {-2.3, 2.025, -2.5, 2.25, 0.3},
                           {-2.7, 2.025, -3, 2.25, 0.3},
                           {-2.7, 1.8, -3, 1.8, 0.3},
                           {-2.7, 1.575, -3, 1.35, 0.3},
                           {-2.5, 1.125, -2.65, 0.9375, 0.3},
                           {-2, 0.9, -1.9, 0.6, 0.3}}};
constexpr Tube kSpout = {{{1.7, 1.425, 1.7, 0.6, 0.66},
                          {2.6, 1.425, 3.1, 0.825, 0.66},
                          {2.3, 2.1, 2.4, 2.025, 0.25},
                          {2.7, 2.4, 3.3, 2.4, 0.25},
                          {2.8, 2.475, 3.525, 2.49375, 0.25},
                          {2.9, 2.475, 3.45, 2.5125, 0.15},
                          {2.8, 2.4, 3.2, 2.4, 0.15}}};

// Bernstein's polynomials of degree 3. The ends are hit exactly.
std::array<double, 4> weights(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

template <typename P> P blend(const std::array<P, 4>& points, double t) {
    const auto w = weights(t);
    P sum = w[0] * points[0];
    for (std::size_t i = 1; i < 4; ++i) sum += w[i] * points[i];
    return sum;
}

struct Rows {
    std::uint32_t first, around;
    std::uint32_t at(std::uint32_t row, std::uint32_t i) const { return first + row * around + i % around; }
};

// One row of vertices after the other: a quad between each two and their next ones, turned so that it faces outwards.
void add_quads(Mesh& mesh, const Rows& rows, std::uint32_t count, bool rows_first) {
    for (std::uint32_t row = 0; row + 1 < count; ++row)
        for (std::uint32_t i = 0; i < rows.around; ++i) {
            const std::uint32_t a = rows.at(row, i), along = rows.at(row + 1, i), both = rows.at(row + 1, i + 1),
                                across = rows.at(row, i + 1);
            if (rows_first)
                add_face(mesh, {a, along, both, across});
            else
                add_face(mesh, {a, across, both, along});
        }
}

template <std::size_t N>
void add_turned(Mesh& mesh, const std::array<std::array<std::array<double, 2>, 4>, N>& curves, std::uint32_t pieces) {
    const Rows rows{static_cast<std::uint32_t>(mesh.positions.size()), 4 * pieces};
    const std::array<glm::dvec2, 4> quarter{{{1, 0}, {1, kQuarter}, {kQuarter, 1}, {0, 1}}};
    for (std::uint32_t row = 0; row <= N * pieces; ++row) {
        const std::size_t curve = std::min<std::size_t>(row / pieces, N - 1);
        Curve points;
        for (std::size_t i = 0; i < 4; ++i) points[i] = {curves[curve][i][0], curves[curve][i][1]};
        const glm::dvec2 p = blend(points, double(row - curve * pieces) / pieces);
        for (std::uint32_t i = 0; i < rows.around; ++i) {
            glm::dvec2 q = p.x * blend(quarter, double(i % pieces) / pieces);
            for (std::uint32_t turn = 0; turn < i / pieces; ++turn) q = {-q.y, q.x};
            mesh.positions.emplace_back(q.x, p.y, -q.y);
        }
    }
    add_quads(mesh, rows, static_cast<std::uint32_t>(N) * pieces + 1, true);
}

// The point of a tube's patch: half of its outline is one, the other half its mirror image.
glm::dvec3 tube_point(const Tube& tube, std::uint32_t row, std::uint32_t i, std::uint32_t pieces) {
    const std::uint32_t patch = std::min(row / pieces, 1u);
    const bool mirrored = i > pieces;
    const double along = double(row - patch * pieces) / pieces, across = double(mirrored ? 2 * pieces - i : i) / pieces;
    std::array<glm::dvec3, 4> points;
    for (std::size_t k = 0; k < 4; ++k) {
        const Outline& o = tube[3 * patch + k];
        const std::array<glm::dvec3, 4> half{{{o.inner_x, o.inner_height, 0},
                                              {o.inner_x, o.inner_height, o.half_width},
                                              {o.outer_x, o.outer_height, o.half_width},
                                              {o.outer_x, o.outer_height, 0}}};
        points[k] = blend(half, across);
    }
    const glm::dvec3 p = blend(points, along);
    return {p.x, p.y, mirrored ? -p.z : p.z};
}

void add_tube(Mesh& mesh, const Tube& tube, std::uint32_t pieces) {
    const Rows rows{static_cast<std::uint32_t>(mesh.positions.size()), 2 * pieces};
    for (std::uint32_t row = 0; row <= 2 * pieces; ++row)
        for (std::uint32_t i = 0; i < rows.around; ++i) mesh.positions.emplace_back(tube_point(tube, row, i, pieces));
    add_quads(mesh, rows, 2 * pieces + 1, false);
}

} // namespace

Scene make_teapot(const MakeValues& values) {
    Scene scene;
    const auto pieces = static_cast<std::uint32_t>(values.count("pieces"));
    Mesh mesh;
    mesh.name = "teapot";
    add_turned(mesh, kLid, pieces);
    add_turned(mesh, kPot, pieces);
    add_tube(mesh, kHandle, pieces);
    add_tube(mesh, kSpout, pieces);
    const std::uint32_t chrome = add_glossy(scene, "chrome", glm::vec3(0.06f), 0.8f, 120);
    scene.materials[chrome].environment = static_cast<float>(values["environment"]);
    add_mesh(scene, std::move(mesh), chrome).crease = static_cast<float>(radians_of(60));
    add_camera(scene, {2.4, 4.2, 7.4}, {0.25, 1.45, 0}, 38);
    add_point_light(scene, {-4, 6, 5}, glm::vec3(6, 5.6f, 5));
    add_directional_light(scene, {-1, -0.5, -0.4}, {0.15f, 0.2f, 0.3f});
    scene.environment = {{0.02f, 0.03f, 0.05f}, glm::vec3(0.15f), {}};
    return scene;
}

} // namespace lightbench
