// Objects of the scene as triangles, spheres and affine images of canonical shapes. In: Scene, its facets. Out: RayPrimitives by number.
#include "accel/primitives.h"

#include "scene/primitive_meshes.h"

#include <cmath>

namespace lightbench {
namespace {

using namespace gpu_layout;

// An object's own triangles, by polygon, whatever order the clusters of the rasteriser left them in: a counting sort that keeps the order
// of the triangles of one polygon. Polygons are numbered object by object.
std::vector<std::uint32_t> triangle_order(const RasterGeometry& geometry) {
    const std::size_t triangles = geometry.indices.size() / 3;
    const auto polygon_of = [&](std::size_t t) { return geometry.vertices.positions[geometry.indices[3 * t]].polygon; };
    std::vector<std::uint32_t> next(geometry.polygon_objects.size() + 1), order(triangles);
    for (std::size_t t = 0; t < triangles; ++t) ++next[polygon_of(t) + 1];
    for (std::size_t p = 1; p < next.size(); ++p) next[p] += next[p - 1];
    for (std::size_t t = 0; t < triangles; ++t) order[next[polygon_of(t)]++] = static_cast<std::uint32_t>(t);
    return order;
}

void add_triangles(RayPrimitives& out, const RasterGeometry& geometry) {
    const auto order = triangle_order(geometry);
    out.triangles.reserve(order.size());
    out.corners.reserve(order.size());
    for (std::uint32_t t : order) {
        const std::uint32_t *corner = &geometry.indices[3 * std::size_t{t}], a = corner[0], b = corner[1], c = corner[2];
        const auto& vertices = geometry.vertices;
        const std::uint32_t polygon = vertices.positions[a].polygon;
        const uint surface = vertices.normals.empty() ? geometry.polygons.normals[polygon].material : vertices.normals[a].material;
        const auto number = static_cast<std::uint32_t>(out.triangles.size());
        out.triangles.push_back({vertices.positions[a].position, number, vertices.positions[b].position, surface,
                                 vertices.positions[c].position, geometry.polygon_objects[polygon]});
        out.corners.push_back({a, b, c, polygon});
    }
}

// A canonical shape as it stands: back takes it to frame axes about `center`.
struct Image {
    uint kind = kShapeBox;
    glm::dmat3 back{1};
    glm::dvec3 center{0}; // frame
    double p0 = 0, p1 = 0, p2 = 0;
};

// The inverse by cofactors: of a matrix whose scales are far apart it loses nothing to subtraction (scene/tessellate_placement.h).
glm::dmat3 inverse_of(const glm::dmat3& m) {
    const glm::dmat3 cofactors = normal_matrix(m);
    return glm::transpose(cofactors) / std::abs(glm::dot(m[0], cofactors[0]));
}

// None if the matrix flattens, or if its inverse leaves the range of float32. Scaled first, lest the determinant of a tiny shape underflow.
std::optional<glm::dmat3> finite_inverse(const glm::dmat3& m) {
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(m[i][j]));
    if (!(largest > 0)) return std::nullopt;
    const glm::dmat3 inverse = inverse_of(m / largest) / largest;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(inverse[i][j]) <= double{3.4e38f})) return std::nullopt;
    return inverse;
}

class Adder {
  public:
    Adder(RayPrimitives& out, const Scene& scene, const RasterGeometry& geometry) : out_(out), scene_(scene), geometry_(geometry) {}

    void add(std::uint32_t object) {
        number_ = object;
        placement_ = placement_of(scene_.transforms[scene_.objects[object].transform]);
        std::visit(*this, scene_.objects[object].shape);
    }

    void operator()(const MeshUse&) {}
    void operator()(const Polygon&) {}

    void operator()(const Sphere& s) {
        if (!placement_.similarity) return add_shape({kShapeBall, linear(glm::dmat3(s.radius)), frame_point(s.center)});
        const auto radius = static_cast<float>(out_.frame.scale * *placement_.similarity * s.radius);
        if (!(radius > 0)) return void(++out_.dropped);
        out_.spheres.push_back({glm::vec3(frame_point(s.center)), radius, 0, geometry_.object_surfaces[number_], number_, 0});
    }

    void operator()(const Box& b) {
        const glm::dvec3 half = 0.5 * b.max - 0.5 * b.min;
        add_shape({kShapeBox, linear({{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}), frame_point(center_of(b))});
    }

    void operator()(const Cylinder& c) { (*this)(cone_of(c)); }

    void operator()(const Cone& c) {
        const glm::dvec3 half = 0.5 * c.top - 0.5 * c.base;
        const double radius = std::max(c.base_radius, c.top_radius);
        if (half == glm::dvec3(0) || !(radius > 0)) return void(++out_.dropped);
        const Plane plane = plane_across(glm::normalize(half));
        add_shape({kShapeCone, linear({radius * plane.x, radius * plane.y, half}), frame_point(center_of(c)), c.base_radius / radius,
                   c.top_radius / radius, c.capped ? 1.0 : 0.0});
    }

    void operator()(const Torus& t) {
        const glm::dvec3 axis = glm::normalize(t.axis);
        const Plane plane = plane_across(axis);
        add_shape({kShapeTorus, linear(t.major * glm::dmat3(plane.x, plane.y, axis)), frame_point(t.center), t.minor / t.major});
    }

  private:
    glm::dmat3 linear(const glm::dmat3& object_from_shape) const { return out_.frame.scale * (placement_.linear * object_from_shape); }

    // Relative to the frame's origin before anything is scaled or added: far from the world's origin nothing is lost (SC-2).
    glm::dvec3 frame_point(const glm::dvec3& p) const {
        return out_.frame.scale * ((placement_.translation - out_.frame.origin) + placement_.linear * p);
    }

    void add_shape(const Image& image) {
        const auto inverse = finite_inverse(image.back);
        const bool sound = inverse && std::isfinite(static_cast<float>(image.p0));
        if (!sound || !finite_inverse(glm::dmat3(glm::mat3(*inverse)))) return void(++out_.dropped);
        const glm::mat3 rows(glm::transpose(*inverse)), back(glm::transpose(image.back));
        const glm::vec3 c(image.center);
        out_.shapes.push_back({rows[0],
                               c.x,
                               rows[1],
                               c.y,
                               rows[2],
                               c.z,
                               image.kind,
                               static_cast<float>(image.p0),
                               static_cast<float>(image.p1),
                               static_cast<float>(image.p2),
                               0,
                               geometry_.object_surfaces[number_],
                               number_,
                               0,
                               back[0],
                               0,
                               back[1],
                               0,
                               back[2],
                               0});
    }

    RayPrimitives& out_;
    const Scene& scene_;
    const RasterGeometry& geometry_;
    std::uint32_t number_ = 0;
    Placement placement_;
};

} // namespace

RayPrimitives ray_primitives(const Scene& scene, const RasterGeometry& geometry) {
    RayPrimitives out;
    out.frame = geometry.frame;
    add_triangles(out, geometry);
    Adder adder(out, scene, geometry);
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) adder.add(i);
    auto number = static_cast<std::uint32_t>(out.triangles.size());
    for (auto& sphere : out.spheres) sphere.number = number++;
    for (auto& shape : out.shapes) shape.number = number++;
    return out;
}

} // namespace lightbench
