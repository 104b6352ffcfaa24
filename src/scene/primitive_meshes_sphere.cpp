// The sphere as a geodesic: a solid of 8 or 20 triangles that are cut into pieces^2 each and blown up to the sphere.
#include "scene/primitive_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace lightbench {
namespace {

constexpr std::uint32_t kMaxPieces = 128;

// The corners of a solid with triangles for faces, of any size.
using Solid = std::vector<glm::dvec3>;

const Solid& solid_of(std::uint32_t faces) {
    constexpr double phi = std::numbers::phi;
    static const Solid kOctahedron = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
    static const Solid kIcosahedron = {{0, -1, -phi}, {0, -1, phi}, {0, 1, -phi},  {0, 1, phi},  {-1, -phi, 0}, {-1, phi, 0},
                                       {1, -phi, 0},  {1, phi, 0},  {-phi, 0, -1}, {phi, 0, -1}, {-phi, 0, 1},  {phi, 0, 1}};
    return faces == 8 ? kOctahedron : kIcosahedron;
}

// Corners nearer than 1.5 times the solid's radius (edges are 1.41 and 1.05 of it, what is farther is 1.70 and more) are neighbours; three
// neighbours are a face, turned so that it looks outwards.
std::vector<std::array<std::uint32_t, 3>> faces_of(const Solid& solid) {
    const double reach = 1.5 * glm::length(solid[0]);
    const auto neighbours = [&](std::uint32_t a, std::uint32_t b) { return glm::distance(solid[a], solid[b]) < reach; };
    const auto n = static_cast<std::uint32_t>(solid.size());
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t a = 0; a < n; ++a)
        for (std::uint32_t b = a + 1; b < n; ++b)
            for (std::uint32_t c = b + 1; c < n; ++c) {
                if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
                const bool outwards = glm::dot(solid[a], glm::cross(solid[b], solid[c])) > 0;
                faces.push_back(outwards ? std::array{a, b, c} : std::array{a, c, b});
            }
    return faces;
}

// Points of the lattice on the corners, edges and faces of the solid, each made once. A point is its corners' mean with whole
// weights, so twice as many pieces hold the same points bit for bit.
class Geodesic {
  public:
    explicit Geodesic(Cuts cuts) : pieces_(cuts.along), solid_(solid_of(cuts.across)) {}
    Faces build();

  private:
    std::uint32_t point(const std::array<std::uint32_t, 3>& corners, std::array<std::uint32_t, 3> weights);

    const std::uint32_t pieces_;
    const Solid& solid_;
    std::map<std::array<std::uint32_t, 4>, std::uint32_t>
        shared_; // points of corners and edges: (corner, weight) twice, lower corner first
    Faces faces_;
};

std::uint32_t Geodesic::point(const std::array<std::uint32_t, 3>& corners, std::array<std::uint32_t, 3> weights) {
    std::array<std::array<std::uint32_t, 2>, 3> terms{{{kNone, 0}, {kNone, 0}, {kNone, 0}}}; // unused ones sort last
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (weights[i] > 0) terms[count++] = {corners[i], weights[i]};
    std::sort(terms.begin(), terms.end());
    const std::array<std::uint32_t, 4> key{terms[0][0], terms[0][1], terms[1][0], terms[1][1]};
    if (count < 3)
        if (const auto known = shared_.find(key); known != shared_.end()) return known->second;
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < count; ++i) sum += double(terms[i][1]) * solid_[terms[i][0]];
    const auto index = static_cast<std::uint32_t>(faces_.points.size());
    faces_.points.push_back(glm::normalize(sum));
    if (count < 3) shared_[key] = index;
    return index;
}

Faces Geodesic::build() {
    const std::uint32_t n = pieces_;
    std::vector<std::uint32_t> row, next;
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        faces_.corners.insert(faces_.corners.end(), {{a, a}, {b, b}, {c, c}});
        faces_.close_face();
    };
    for (const auto& corners : faces_of(solid_))
        for (std::uint32_t i = 0; i <= n; ++i, row.swap(next)) {
            next.clear();
            for (std::uint32_t j = 0; j <= i; ++j) next.push_back(point(corners, {n - i, i - j, j}));
            for (std::uint32_t j = 0; j < i; ++j) triangle(row[j], next[j], next[j + 1]);
            for (std::uint32_t j = 1; j < i; ++j) triangle(row[j - 1], next[j], row[j]);
        }
    faces_.normals = faces_.points;
    return std::move(faces_);
}

} // namespace

// Of the icosahedron the largest triangles lie about the middle of a face, where the lattice, of edge 2 / (sqrt(phi^2 + 1) pieces) of the
// radius, is blown up by 1 over the inradius 0.79465: circumradius R = 0.7639 / pieces, and the plane stays R^2 / 2 below the sphere, less
// for few pieces. The test of the chord error fixes that 0.292 is no less than needed. The octahedron's faces stay 1 - 1/sqrt(3) below it:
// it serves for spheres of a pixel.
Cuts cuts_of(const Sphere& sphere, double error, unsigned halvings) {
    const bool tiny = error >= (1 - 1 / std::sqrt(3.0)) * sphere.radius;
    const double pieces = std::ceil(std::sqrt(0.292 * sphere.radius / error));
    return {static_cast<std::uint32_t>(std::clamp(pieces, 1.0, double(kMaxPieces))) << halvings, tiny ? 8u : 20u};
}

std::size_t triangle_count(const Sphere&, Cuts cuts) {
    return std::size_t(cuts.across) * cuts.along * cuts.along;
}

Faces unit_sphere_faces(Cuts cuts) {
    return Geodesic(cuts).build();
}

} // namespace lightbench
