// Bounding boxes of objects in the world, exact up to rounding, and the frame that geometry is handed on in. In: Scene. Out: Bounds, Frame.
#include "scene/tessellate.h"
#include "scene/tessellate_placement.h"

#include <cmath>

namespace lightbench {
namespace {

// Half the extent, along each world axis, of the unit disc across `axis` after `linear`: the lengths of the disc's part of each row.
glm::dvec3 disc_extent(const glm::dmat3& linear, const glm::dvec3& axis) {
    const Plane plane = plane_across(axis);
    const glm::dvec3 u = linear * plane.x, v = linear * plane.y;
    return glm::sqrt(u * u + v * v);
}

// Half the extent of the unit ball after `linear`: the lengths of its rows.
glm::dvec3 ball_extent(const glm::dmat3& linear) {
    return glm::sqrt(linear[0] * linear[0] + linear[1] * linear[1] + linear[2] * linear[2]);
}

struct BoundsAdder {
    const Scene& scene;
    const Placement placement;
    Bounds& bounds;

    void point(const glm::dvec3& p) const { bounds.add(placement.translation + placement.linear * p); }

    void around(const glm::dvec3& center, const glm::dvec3& extent) const {
        const glm::dvec3 c = placement.translation + placement.linear * center;
        bounds.add(c - extent);
        bounds.add(c + extent);
    }

    void between(const glm::dvec3& base, double base_radius, const glm::dvec3& top, double top_radius) const {
        if (base == top) return point(base);
        const glm::dvec3 extent = disc_extent(placement.linear, glm::normalize(top - base));
        around(base, base_radius * extent);
        around(top, top_radius * extent);
    }

    void operator()(const Sphere& s) const { around(s.center, s.radius * ball_extent(placement.linear)); }
    void operator()(const Cylinder& c) const { between(c.base, c.radius, c.top, c.radius); }
    void operator()(const Cone& c) const { between(c.base, c.base_radius, c.top, c.top_radius); }

    // A torus is the sum of its circle and a ball, and extents of sums add up.
    void operator()(const Torus& t) const {
        around(t.center, t.major * disc_extent(placement.linear, glm::normalize(t.axis)) + t.minor * ball_extent(placement.linear));
    }

    void operator()(const Polygon& polygon) const {
        for (const auto& p : polygon.points) point(p);
    }

    void operator()(const Box& box) const {
        for (int i = 0; i < 8; ++i) point({i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z});
    }

    // Vertices that no face uses do not count: they are not seen.
    void operator()(const MeshUse& use) const {
        const Mesh& mesh = scene.meshes[use.mesh];
        std::vector<bool> used(mesh.positions.size());
        for (std::uint32_t corner : mesh.corners) used[corner] = true;
        for (std::size_t i = 0; i < used.size(); ++i)
            if (used[i]) point(glm::dvec3(mesh.positions[i]));
    }
};

} // namespace

Bounds bounds_of(const Scene& scene) {
    Bounds bounds;
    for (const Object& object : scene.objects)
        std::visit(BoundsAdder{scene, placement_of(scene.transforms[object.transform]), bounds}, object.shape);
    return bounds;
}

Bounds bounds_of(const Scene& scene, const Object& object) {
    Bounds bounds;
    std::visit(BoundsAdder{scene, placement_of(scene.transforms[object.transform]), bounds}, object.shape);
    return bounds;
}

Frame frame_of(const Bounds& bounds) {
    if (bounds.empty()) return {};
    Frame frame;
    frame.origin = 0.5 * bounds.min + 0.5 * bounds.max;
    const double radius = glm::length(glm::max(bounds.max - frame.origin, frame.origin - bounds.min));
    if (radius == 0) return frame;
    frame.scale = std::ldexp(1.0, -std::ilogb(radius));
    frame.radius = radius * frame.scale;
    return frame;
}

} // namespace lightbench
