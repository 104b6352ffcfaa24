// How finely curved primitives are cut, and the box, the cylinder, the cone and the torus as faces. The sphere is in primitive_meshes_sphere.cpp.
#include "scene/primitive_meshes.h"

#include "scene/normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lightbench {
namespace {

// A shape of a few pixels costs little, and a camera that grazes a shape does not exhaust the machine. The quads of the roughest cuts bend
// by 60 degrees at most, so that corner normals face well away from kMinFacing.
constexpr double kMinAround = 6, kMaxAround = 1024, kMinTube = 6, kMaxTube = 256;

// A chord of an arc of radius r over the angle 2 pi / n stays r (1 - cos(pi / n)) below it. 1 - cos x = 2 sin^2(x / 2) keeps the digits.
std::uint32_t pieces_of_circle(double radius, double error, double least, double most, unsigned halvings) {
    const double sine = std::sqrt(std::min(1.0, error / (2 * radius)));
    const double pieces = std::numbers::pi / (2 * std::asin(sine));
    return static_cast<std::uint32_t>(std::clamp(std::ceil(pieces), least, most)) << halvings;
}

struct Turn {
    double cosine, sine;
};

std::vector<Turn> turns(std::uint32_t n) {
    std::vector<Turn> all(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        all[i] = {std::cos(angle), std::sin(angle)};
    }
    return all;
}

std::uint32_t add(std::vector<glm::dvec3>& to, const glm::dvec3& v) {
    to.push_back(v);
    return static_cast<std::uint32_t>(to.size() - 1);
}

// Rings of points about an axis; a ring of radius 0 is one point. Ring by ring, the side and the caps of a cone are the same thing.
struct Ring {
    std::uint32_t first = 0;
    bool point = false;
    std::uint32_t at(std::uint32_t i, std::uint32_t around) const { return point ? first : first + i % around; }
};

class ConeBuilder {
  public:
    ConeBuilder(const Cone& cone, Cuts cuts)
        : cone_(cone), cuts_(cuts), axis_(glm::normalize(cone.top - cone.base)), plane_(plane_across(axis_)), turns_(turns(cuts.along)),
          half_height_(0.5 * glm::length(cone.top - cone.base)) {}
    Faces build();

  private:
    Ring ring(double height, double radius);
    double radius_at(std::uint32_t row) const { return cone_.base_radius + (cone_.top_radius - cone_.base_radius) * row / cuts_.across; }
    glm::dvec3 side_normal(double cosine, double sine) const;
    void side(const std::vector<Ring>& rows);
    void cap(const Ring& rim, double height, double radius, bool top);

    const Cone& cone_;
    const Cuts cuts_;
    const glm::dvec3 axis_;
    const Plane plane_;
    const std::vector<Turn> turns_;
    const double half_height_;
    Faces faces_;
};

Ring ConeBuilder::ring(double height, double radius) {
    const Ring made{static_cast<std::uint32_t>(faces_.points.size()), radius == 0};
    if (made.point)
        faces_.points.push_back(height * axis_);
    else
        for (const Turn& t : turns_) faces_.points.push_back(height * axis_ + radius * (t.cosine * plane_.x + t.sine * plane_.y));
    return made;
}

// The side's normal leans by the slope: across (2 half_height, base_radius - top_radius) in the plane of the axis.
glm::dvec3 ConeBuilder::side_normal(double cosine, double sine) const {
    const glm::dvec3 outward = cosine * plane_.x + sine * plane_.y;
    return glm::normalize(2 * half_height_ * outward + (cone_.base_radius - cone_.top_radius) * axis_);
}

// The apex has no normal of its own: there each piece takes the normal of its middle, so that shading does not swirl about the tip.
void ConeBuilder::side(const std::vector<Ring>& rows) {
    const std::uint32_t n = cuts_.along, normals = static_cast<std::uint32_t>(faces_.normals.size());
    for (const Turn& t : turns_) faces_.normals.push_back(side_normal(t.cosine, t.sine));
    for (std::size_t r = 0; r + 1 < rows.size(); ++r)
        for (std::uint32_t i = 0; i < n; ++i) {
            const Corner a{rows[r].at(i, n), normals + i}, b{rows[r].at(i + 1, n), normals + (i + 1) % n};
            const Corner c{rows[r + 1].at(i + 1, n), normals + (i + 1) % n}, d{rows[r + 1].at(i, n), normals + i};
            const double middle = 2 * std::numbers::pi * (i + 0.5) / n;
            if (rows[r].point || rows[r + 1].point) {
                const std::uint32_t tip = add(faces_.normals, side_normal(std::cos(middle), std::sin(middle)));
                if (rows[r].point)
                    faces_.corners.insert(faces_.corners.end(), {Corner{a.point, tip}, c, d});
                else
                    faces_.corners.insert(faces_.corners.end(), {a, b, Corner{c.point, tip}});
            } else
                faces_.corners.insert(faces_.corners.end(), {a, b, c, d});
            faces_.close_face();
            faces_.hubs.push_back({kNone, kNone});
        }
}

// Unless it is subdivided a cap is one polygon, whose triangles meet in its middle.
void ConeBuilder::cap(const Ring& rim, double height, double radius, bool top) {
    const std::uint32_t normal = add(faces_.normals, top ? axis_ : -axis_), n = cuts_.along;
    if (cuts_.across == 1) {
        const Corner hub{ring(height, 0).first, normal};
        for (std::uint32_t i = 0; i < n; ++i) faces_.corners.push_back({rim.at(top ? i : n - i, n), normal});
        faces_.close_face();
        faces_.hubs.push_back(hub);
        return;
    }
    Ring inner = ring(height, 0);
    for (std::uint32_t r = 1; r <= cuts_.across; ++r) {
        const Ring outer = r == cuts_.across ? rim : ring(height, radius * r / cuts_.across);
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t now = top ? i : i + 1, then = top ? i + 1 : i;
            faces_.corners.insert(faces_.corners.end(),
                                  {{inner.at(now, n), normal}, {outer.at(now, n), normal}, {outer.at(then, n), normal}});
            if (!inner.point) faces_.corners.push_back({inner.at(then, n), normal});
            faces_.close_face();
            faces_.hubs.push_back({kNone, kNone});
        }
        inner = outer;
    }
}

Faces ConeBuilder::build() {
    std::vector<Ring> rows;
    for (std::uint32_t r = 0; r <= cuts_.across; ++r)
        rows.push_back(ring(half_height_ * (2.0 * r / cuts_.across - 1), r == cuts_.across ? cone_.top_radius : radius_at(r)));
    side(rows);
    if (cone_.capped && cone_.base_radius > 0) cap(rows.front(), -half_height_, cone_.base_radius, false);
    if (cone_.capped && cone_.top_radius > 0) cap(rows.back(), half_height_, cone_.top_radius, true);
    return std::move(faces_);
}

} // namespace

Cone cone_of(const Cylinder& c) {
    return {c.base, c.top, c.radius, c.radius, c.capped};
}
glm::dvec3 center_of(const Cone& cone) {
    return 0.5 * cone.base + 0.5 * cone.top;
}
glm::dvec3 center_of(const Box& box) {
    return 0.5 * box.min + 0.5 * box.max;
}

Cuts cuts_of(const Cylinder& cylinder, double error, unsigned halvings) {
    return cuts_of(cone_of(cylinder), error, halvings);
}

Cuts cuts_of(const Cone& cone, double error, unsigned halvings) {
    return {pieces_of_circle(std::max(cone.base_radius, cone.top_radius), error, kMinAround, kMaxAround, halvings), 1u << halvings};
}

// The errors of the two circles add up, and equal shares need the fewest quads.
Cuts cuts_of(const Torus& torus, double error, unsigned halvings) {
    return {pieces_of_circle(torus.major + torus.minor, error / 2, kMinAround, kMaxAround, halvings),
            pieces_of_circle(torus.minor, error / 2, kMinTube, kMaxTube, halvings)};
}

std::size_t triangle_count(const Cylinder& cylinder, Cuts cuts) {
    return triangle_count(cone_of(cylinder), cuts);
}

std::size_t triangle_count(const Cone& cone, Cuts cuts) {
    const std::size_t tips = (cone.base_radius == 0) + (cone.top_radius == 0), rows = 2 * std::size_t(cuts.across);
    return cuts.along * (rows - tips + (cone.capped ? (2 - tips) * (rows - 1) : 0));
}

std::size_t triangle_count(const Torus&, Cuts cuts) {
    return 2 * std::size_t(cuts.along) * cuts.across;
}

Faces box_faces(const Box& box) {
    const glm::dvec3 half = 0.5 * box.max - 0.5 * box.min;
    Faces faces;
    for (int i = 0; i < 8; ++i) faces.points.push_back(half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    constexpr std::uint32_t kLoops[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (int face = 0; face < 6; ++face) {
        glm::dvec3 normal(0);
        normal[face / 2] = face % 2 ? 1 : -1;
        const std::uint32_t index = add(faces.normals, normal);
        for (std::uint32_t point : kLoops[face]) faces.corners.push_back({point, index});
        faces.close_face();
    }
    return faces;
}

Faces cone_faces(const Cone& cone, Cuts cuts) {
    if (cone.base == cone.top) return {};
    return ConeBuilder(cone, cuts).build();
}

// The quads of a torus are planar: two of their sides are parallel.
Faces torus_faces(const Torus& torus, Cuts cuts) {
    const glm::dvec3 axis = glm::normalize(torus.axis);
    const Plane plane = plane_across(axis);
    const auto around = turns(cuts.along), tube = turns(cuts.across);
    Faces faces;
    for (const Turn& u : around) {
        const glm::dvec3 outward = u.cosine * plane.x + u.sine * plane.y;
        for (const Turn& v : tube) {
            const glm::dvec3 normal = v.cosine * outward + v.sine * axis;
            faces.points.push_back(torus.major * outward + torus.minor * normal);
            faces.normals.push_back(glm::normalize(normal));
        }
    }
    const auto at = [&](std::uint32_t i, std::uint32_t j) -> Corner {
        const std::uint32_t index = i % cuts.along * cuts.across + j % cuts.across;
        return {index, index};
    };
    for (std::uint32_t i = 0; i < cuts.along; ++i)
        for (std::uint32_t j = 0; j < cuts.across; ++j) {
            faces.corners.insert(faces.corners.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            faces.close_face();
        }
    return faces;
}

void place(Faces& faces, const Placement& placement) {
    for (auto& p : faces.points) p = placement.linear * p;
    for (auto& n : faces.normals) {
        const glm::dvec3 turned = placement.normal * n;
        const double length = glm::length(turned);
        n = length > 0 ? turned / length : glm::dvec3(0);
    }
    if (!placement.mirrored) return;
    for (std::size_t f = 0; f < faces.count(); ++f) std::reverse(faces.loop(f).begin() + 1, faces.loop(f).end());
}

} // namespace lightbench
