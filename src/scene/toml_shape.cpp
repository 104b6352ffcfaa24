// The keys of each shape, and what makes a shape impossible.
#include "scene/check_geometry.h"
#include "scene/toml_parts.h"

#include <array>
#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr Rule kRadiusOrZero{0, limits::kMaxCoordinate, false, false, "it must lie between 0 and 1e15 (limit kMaxCoordinate)"};

bool read_sphere(Section& s, Shape& out) {
    Sphere sphere;
    read_vector(s, "center", sphere.center, kCoordinate);
    read(s, "radius", sphere.radius, kLength);
    out = sphere;
    return true;
}

bool read_points(Section& s, const toml::array& array, std::vector<glm::dvec3>& points) {
    if (array.size() > limits::kMaxPolygonPoints) {
        fault(s, array, fmt::format("points has {} points; at most {} (limit kMaxPolygonPoints)", array.size(), limits::kMaxPolygonPoints));
        return false;
    }
    bool fine = true;
    for (const toml::node& node : array) {
        glm::dvec3 point(0);
        fine &= vector_of(s, node, fmt::format("point {}", points.size() + 1), point, kCoordinate);
        points.push_back(point);
    }
    return fine;
}

void check_polygon(Section& s, const toml::node& where, const std::vector<glm::dvec3>& points) {
    if (points.size() < 3)
        return fault(s, where, fmt::format("points has {} point{}; a polygon needs 3", points.size(), points.size() == 1 ? "" : "s"));
    if (has_no_area(points)) return fault(s, where, "all points lie on one line; a polygon needs an area");
    const Planarity p = planarity_of(points);
    if (p.planar()) return;
    fault(s, where,
          fmt::format("a point lies {:.3g} off the polygon's plane; it must lie within {:.3g}; cut the polygon into triangles", p.deviation,
                      p.allowed));
}

// One a point, of any length but 0; kept as unit vectors.
void read_normals(Section& s, Polygon& polygon) {
    const toml::node* node = find(s, "normals");
    const toml::array* array = node ? node->as_array() : nullptr;
    if (!node) return;
    if (!array || array->size() != polygon.points.size())
        return fault(s, *node, fmt::format("normals must be an array of {} vectors, one a point", polygon.points.size()));
    for (const toml::node& element : *array) {
        glm::dvec3 n(0);
        if (!vector_of(s, element, fmt::format("normal {}", polygon.normals.size() + 1), n, kAnyFloat)) n = glm::dvec3(0, 0, 1);
        if (!(glm::length(n) > 0)) fault(s, element, "a normal is [0, 0, 0]; it must point somewhere");
        polygon.normals.push_back(glm::vec3(glm::normalize(n)));
    }
}

bool read_polygon(Section& s, Shape& out) {
    Polygon polygon;
    const toml::node* node = find(s, "points");
    const toml::array* array = node ? node->as_array() : nullptr;
    if (!node)
        fault(s, *s.table, "points is missing; give [[x, y, z], ...]");
    else if (!array)
        fault(s, *node, fmt::format("points is {}; it must be an array of points [[x, y, z], ...]", kind_name(*node)));
    else if (read_points(s, *array, polygon.points))
        check_polygon(s, *node, polygon.points);
    read_normals(s, polygon);
    out = std::move(polygon);
    return true;
}

bool read_box(Section& s, Shape& out) {
    constexpr std::string_view kAxis = "xyz";
    Box box;
    const bool min = read_vector(s, "min", box.min, kCoordinate), max = read_vector(s, "max", box.max, kCoordinate);
    const bool known = (min || !s.table->get("min")) && (max || !s.table->get("max"));
    for (int i = 0; known && i < 3; ++i)
        if (!(box.min[i] < box.max[i]))
            fault(s, place_of(s, max ? "max" : "min"),
                  fmt::format("max's {} is {}; it must be greater than min's, {}", kAxis[static_cast<std::size_t>(i)], box.max[i],
                              box.min[i]));
    out = box;
    return true;
}

void check_axis(Section& s, std::string_view end, const glm::dvec3& base, const glm::dvec3& top) {
    if (base == top) fault(s, place_of(s, end), fmt::format("{} is the same point as base; they must differ", end));
}

bool read_cylinder(Section& s, Shape& out) {
    Cylinder c;
    read_vector(s, "base", c.base, kCoordinate);
    read_vector(s, "top", c.top, kCoordinate);
    check_axis(s, "top", c.base, c.top);
    read(s, "radius", c.radius, kLength);
    read(s, "capped", c.capped);
    out = c;
    return true;
}

bool read_cone(Section& s, Shape& out) {
    Cone c;
    read_vector(s, "base", c.base, kCoordinate);
    read_vector(s, "top", c.top, kCoordinate);
    read_vector(s, "apex", c.top, kCoordinate);
    const bool apex = s.table->get("apex"), top = s.table->get("top");
    if (apex && top) fault(s, place_of(s, "apex"), "both apex and top; give apex for a point, top and top_radius for a cone cut off");
    check_axis(s, apex ? "apex" : "top", c.base, c.top);
    read(s, "base_radius", c.base_radius, kRadiusOrZero);
    read(s, "top_radius", c.top_radius, kRadiusOrZero);
    if (apex && c.top_radius > 0) fault(s, place_of(s, "top_radius"), "an apex has no radius; write top in place of apex");
    if (c.base_radius == 0 && c.top_radius == 0)
        fault(s, place_of(s, "base_radius"), "base_radius and top_radius are both 0; one must be greater");
    read(s, "capped", c.capped);
    out = c;
    return true;
}

bool read_torus(Section& s, Shape& out) {
    Torus t;
    read_vector(s, "center", t.center, kCoordinate);
    read_vector(s, "axis", t.axis, kCoordinate);
    if (!(glm::length(t.axis) > 0)) fault(s, place_of(s, "axis"), "axis is [0, 0, 0]; it must point somewhere");
    t.axis = glm::normalize(t.axis);
    read(s, "major", t.major, kLength);
    read(s, "minor", t.minor, kLength);
    out = t;
    return true;
}

} // namespace

bool read_shape(Section& section, std::string_view shape, Shape& out) {
    if (shape == "sphere") return read_sphere(section, out);
    if (shape == "polygon") return read_polygon(section, out);
    if (shape == "cone") return read_cone(section, out);
    if (shape == "box") return read_box(section, out);
    if (shape == "cylinder") return read_cylinder(section, out);
    return read_torus(section, out);
}

} // namespace lightbench
