// Rectangles that somebody cut in two, made whole again, so that they can be cut into grids. Declared in base_faces.h.
#include "radiosity/base_faces.h"

#include "scene/normals.h"
#include "scene/triangulate.h"

namespace lightbench {
namespace {

// The sides opposite the diagonal meet at an angle whose cosine is no larger than this: 75 to 105 degrees.
constexpr double kMostCosine = 0.25;

// Radians between their normals. The bilinear surface that takes their place lies a quarter of a corner's height over the other triangle
// away from them: within 1/256 of the rectangle's width. The walls of the Cornell box as measured fold by 1/122.
constexpr double kMostFold = 1.0 / 64;

class Pairer {
  public:
    Pairer(BaseMesh& base, const BaseEdges& edges, const std::vector<std::uint32_t>& groups)
        : base_(base), edges_(edges), groups_(groups), partner_(base.faces.size(), kNone), diagonal_of_(base.faces.size(), kNone) {}
    void run();

  private:
    const glm::dvec3& point(std::uint32_t corner) const { return base_.points[base_.corners[corner].point]; }
    bool is_half(std::uint32_t diagonal) const;
    bool fits(std::uint32_t a, std::uint32_t b) const;
    std::array<Corner, 4> loop_of(std::uint32_t a, std::uint32_t b) const;

    BaseMesh& base_;
    const BaseEdges& edges_;
    const std::vector<std::uint32_t>& groups_;
    std::vector<std::uint32_t> partner_; // kNone; the corner that starts the diagonal in the other triangle, of the lower of two; gone
    std::vector<std::uint32_t> diagonal_of_;
};

// Is the side that starts at the corner the longest of a triangle, with nearly a right angle opposite?
bool Pairer::is_half(std::uint32_t diagonal) const {
    const BaseFace& face = base_.faces[edges_.face_of_corner[diagonal]];
    if (face.count != 3 || face.hub != kNone) return false;
    const std::uint32_t b = next_corner(base_, edges_, diagonal), c = next_corner(base_, edges_, b);
    const glm::dvec3 u = point(diagonal) - point(c), v = point(b) - point(c), w = u - v;
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v);
    return glm::dot(w, w) > std::max(uu, vv) && uv * uv <= kMostCosine * kMostCosine * uu * vv;
}

// Corners b, a of the one and a, b of the other start the diagonal. Points are kept for the fan about a, which gives the same triangles
// again.
std::array<Corner, 4> Pairer::loop_of(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t b_here = next_corner(base_, edges_, a), c = next_corner(base_, edges_, b_here);
    const std::uint32_t a_there = next_corner(base_, edges_, b), d = next_corner(base_, edges_, a_there);
    return {base_.corners[a], base_.corners[d], base_.corners[b_here], base_.corners[c]};
}

bool Pairer::fits(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t f = edges_.face_of_corner[a], g = edges_.face_of_corner[b];
    const BaseFace &one = base_.faces[f], &other = base_.faces[g];
    if (f == g || partner_[f] != kNone || partner_[g] != kNone || groups_[f] != groups_[g] || one.two_sided != other.two_sided)
        return false;
    if (base_.corners[a].point == base_.corners[b].point || !is_half(a) || !is_half(b)) return false;
    const auto loop = loop_of(a, b);
    std::array<glm::dvec3, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = base_.points[loop[i].point];
    return glm::length(one.normal - other.normal) <= kMostFold && strictly_convex(flatten(points, one.normal));
}

void Pairer::run() {
    constexpr std::uint32_t kGone = kNone - 1;
    for (std::uint32_t e = 0; e < edges_.count(); ++e) {
        const auto users = edges_.users_of(e);
        if (users.size() != 2 || !fits(users[0], users[1])) continue;
        const std::uint32_t f = edges_.face_of_corner[users[0]], g = edges_.face_of_corner[users[1]];
        const bool first = f < g;
        diagonal_of_[std::min(f, g)] = users[first ? 0 : 1];
        partner_[std::min(f, g)] = users[first ? 1 : 0];
        partner_[std::max(f, g)] = kGone;
    }
    std::vector<Corner> corners;
    std::vector<BaseFace> faces;
    for (std::uint32_t f = 0; f < base_.faces.size(); ++f) {
        if (partner_[f] == kGone) continue;
        BaseFace face = base_.faces[f];
        const auto old = base_.loop(face);
        face.first = static_cast<std::uint32_t>(corners.size());
        if (partner_[f] == kNone) {
            corners.insert(corners.end(), old.begin(), old.end());
        } else {
            const auto loop = loop_of(diagonal_of_[f], partner_[f]);
            corners.insert(corners.end(), loop.begin(), loop.end());
            face.count = 4, face.normal = face_normal(base_.points, loop);
        }
        faces.push_back(face);
    }
    base_.corners = std::move(corners), base_.faces = std::move(faces);
}

} // namespace

void pair_triangles(BaseMesh& base, const BaseEdges& edges, const std::vector<std::uint32_t>& groups) {
    Pairer(base, edges, groups).run();
}

} // namespace lightbench
