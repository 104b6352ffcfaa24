// The sphere as a geodesic: an icosahedron whose triangles are cut into pieces^2 each and blown up to the sphere.
#include "scene/primitive_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace lightbench {
namespace {

constexpr std::uint32_t kMaxPieces = 128;

// Corners (0, +-1, +-phi) and their cyclic turns; counter-clockwise seen from outside.
constexpr double kPhi = std::numbers::phi;
constexpr std::array<glm::dvec3, 12> kCorners = {{{0, -1, -kPhi},
                                                  {0, -1, kPhi},
                                                  {0, 1, -kPhi},
                                                  {0, 1, kPhi},
                                                  {-1, -kPhi, 0},
                                                  {-1, kPhi, 0},
                                                  {1, -kPhi, 0},
                                                  {1, kPhi, 0},
                                                  {-kPhi, 0, -1},
                                                  {kPhi, 0, -1},
                                                  {-kPhi, 0, 1},
                                                  {kPhi, 0, 1}}};

// Corners at the distance of an edge (2) are neighbours; three neighbours are a face, turned so that it looks outwards.
std::vector<std::array<std::uint32_t, 3>> icosahedron() {
    const auto neighbours = [](std::uint32_t a, std::uint32_t b) { return glm::distance(kCorners[a], kCorners[b]) < 2.5; };
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c) {
                if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
                const bool outwards = glm::dot(kCorners[a], glm::cross(kCorners[b], kCorners[c])) > 0;
                faces.push_back(outwards ? std::array{a, b, c} : std::array{a, c, b});
            }
    return faces;
}

// Points of the lattice on the corners, edges and faces of the icosahedron, each made once. A point is its corners' mean with whole
// weights, so twice as many pieces hold the same points bit for bit.
class Geodesic {
  public:
    explicit Geodesic(std::uint32_t pieces) : pieces_(pieces) {}
    Faces build();

  private:
    std::uint32_t point(const std::array<std::uint32_t, 3>& corners, std::array<std::uint32_t, 3> weights);

    const std::uint32_t pieces_;
    std::map<std::array<std::uint32_t, 4>, std::uint32_t>
        shared_; // points of corners and edges: (corner, weight) twice, lower corner first
    Faces faces_;
};

std::uint32_t Geodesic::point(const std::array<std::uint32_t, 3>& corners, std::array<std::uint32_t, 3> weights) {
    std::array<std::array<std::uint32_t, 2>, 3> terms;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (weights[i] > 0) terms[count++] = {corners[i], weights[i]};
    std::sort(terms.begin(), terms.begin() + std::ptrdiff_t(count));
    if (count == 1) terms[1] = {kNone, 0};
    const std::array<std::uint32_t, 4> key{terms[0][0], terms[0][1], terms[1][0], terms[1][1]};
    if (count < 3)
        if (const auto known = shared_.find(key); known != shared_.end()) return known->second;
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < count; ++i) sum += double(terms[i][1]) * kCorners[terms[i][0]];
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
    for (const auto& corners : icosahedron())
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

// The largest triangles lie about the middle of a face, where the lattice, of edge 2 / (sqrt(phi^2 + 1) pieces) of the radius, is blown up by
// 1 over the icosahedron's inradius 0.79465: circumradius R = 0.7639 / pieces, and the plane stays R^2 / 2 below the sphere, less for few pieces.
// The test of the chord error fixes that 0.292 is no less than needed.
Cuts cuts_of(const Sphere& sphere, double error, unsigned halvings) {
    const double pieces = std::ceil(std::sqrt(0.292 * sphere.radius / error));
    return {static_cast<std::uint32_t>(std::clamp(pieces, 1.0, double(kMaxPieces))) << halvings, 1};
}

std::size_t triangle_count(const Sphere&, Cuts cuts) {
    return 20 * std::size_t(cuts.along) * cuts.along;
}

Faces unit_sphere_faces(std::uint32_t pieces) {
    return Geodesic(pieces).build();
}

} // namespace lightbench
