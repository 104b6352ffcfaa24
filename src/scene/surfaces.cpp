// Mappings of materials on objects, and the numbers of surfaces. In: material, scene, object. Out: Mapping, matrices, SurfaceTable.
#include "scene/surfaces.h"

#include "scene/primitive_meshes.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

// A right-handed frame in object space and the box about the shape in it.
struct MappingBox {
    glm::dvec3 center{0};  // object space
    glm::dmat3 axes{1};    // columns: x, y, z of mapping space, unit, in object space
    glm::dvec3 extents{1}; // half, along the axes
};

// The box in object axes.
Bounds object_bounds(const Scene& scene, const Object& object) {
    Scene alone;
    alone.objects.push_back(object);
    alone.objects[0].transform = 0;
    const auto* use = std::get_if<MeshUse>(&object.shape);
    if (!use) return bounds_of(alone);
    const Mesh& mesh = scene.meshes[use->mesh];
    Bounds bounds;
    for (std::uint32_t corner : mesh.corners) bounds.add(glm::dvec3(mesh.positions[corner]));
    return bounds;
}

glm::dmat3 turned(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
    return {x, y, z};
}

// The seam lies behind (object -z); of an axis that points to the front itself, below.
glm::dmat3 frame_about(const glm::dvec3& axis) {
    constexpr double kSteep = 0.9; // any number well below 1: it only keeps `back` away from the axis
    const glm::dvec3 back = std::abs(axis.z) > kSteep ? glm::dvec3(0, -1, 0) : glm::dvec3(0, 0, -1);
    const glm::dvec3 x = glm::normalize(back - glm::dot(back, axis) * axis);
    return turned(x, glm::cross(axis, x), axis);
}

// Which axis of the box is its flattest decides; where extents agree a wall comes before a floor. Positions of meshes are float32: two
// extents that are meant to be equal differ by up to four roundings of 2^-24 of the largest coordinate.
glm::dmat3 planar_axes(const Bounds& bounds) {
    const glm::dvec3 size = bounds.max - bounds.min, largest = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
    const double rounding = 0x1p-22 * std::max({largest.x, largest.y, largest.z});
    const double least = std::min({size.x, size.y, size.z}) + rounding;
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    if (size.z <= least) return turned(x, y, z);
    if (size.y <= least) return turned(x, -z, y);
    return turned(-z, y, x);
}

MappingBox box_along(const Bounds& bounds, const glm::dmat3& axes) {
    MappingBox box{0.5 * bounds.min + 0.5 * bounds.max, axes, glm::dvec3(1)};
    const glm::dvec3 half = 0.5 * bounds.max - 0.5 * bounds.min;
    for (int i = 0; i < 3; ++i) box.extents[i] = glm::dot(half, glm::abs(axes[i])); // the axes are those of the object, permuted
    return box;
}

// The shapes that have an axis, about it.
struct AboutAxis {
    MappingBox& box;
    bool operator()(const Sphere& s) const { return box = {s.center, frame_about({0, 1, 0}), glm::dvec3(s.radius)}, true; }
    bool operator()(const Cylinder& c) const { return (*this)(cone_of(c)); }
    bool operator()(const Cone& c) const {
        if (c.base == c.top) return false;
        const double radius = std::max(c.base_radius, c.top_radius), length = glm::length(c.top - c.base);
        return box = {center_of(c), frame_about((c.top - c.base) / length), {radius, radius, 0.5 * length}}, true;
    }
    bool operator()(const Torus& t) const {
        const double outer = t.major + t.minor;
        return box = {t.center, frame_about(glm::normalize(t.axis)), {outer, outer, t.minor}}, true;
    }
    template <typename S> bool operator()(const S&) const { return false; }
};

MappingBox mapping_box(const Scene& scene, const Object& object, Mapping mapping) {
    if (mapping == Mapping::uv) mapping = natural_mapping(object);
    MappingBox box;
    if (mapping == Mapping::planar || !std::visit(AboutAxis{box}, object.shape)) {
        Bounds bounds = object_bounds(scene, object);
        if (bounds.empty()) bounds = {glm::dvec3(0), glm::dvec3(0)};
        box = box_along(bounds, mapping == Mapping::planar ? planar_axes(bounds) : frame_about({0, 1, 0}));
    }
    for (int i = 0; i < 3; ++i)
        if (!(box.extents[i] > 0)) box.extents[i] = 1;
    return box;
}

} // namespace

glm::vec3 straight_opacity(const Material& material) {
    return material.opacity * (1.0f - material.transmission);
}

bool hides_backs(const Material& material) {
    return !material.two_sided.value_or(true) && material.transmission == glm::vec3(0);
}

bool is_translucent(const Material& material) {
    return glm::any(glm::lessThan(straight_opacity(material), glm::vec3(1))) || (material.texture && material.texture->alpha);
}

bool has_uv(const Scene& scene, const Object& object) {
    const auto* use = std::get_if<MeshUse>(&object.shape);
    return use && !scene.meshes[use->mesh].uvs.empty();
}

Mapping natural_mapping(const Object& object) {
    const Shape& shape = object.shape;
    if (std::holds_alternative<Sphere>(shape) || std::holds_alternative<Torus>(shape)) return Mapping::spherical;
    if (std::holds_alternative<Cylinder>(shape) || std::holds_alternative<Cone>(shape)) return Mapping::cylindrical;
    return Mapping::planar;
}

Mapping mapping_of(const Scene& scene, const Object& object, const Material& material) {
    const Mapping asked = material.texture ? material.texture->mapping : Mapping::uv;
    return asked == Mapping::uv && !has_uv(scene, object) ? natural_mapping(object) : asked;
}

bool depends_on_object(const Material& material, const Scene& scene, const Object& object) {
    if (material.bump && material.bump->function != BumpFunction::none) return true;
    const bool mapped = material.texture || (material.bump && material.bump->picture);
    return mapped && mapping_of(scene, object, material) != Mapping::uv;
}

glm::dmat4 mapping_from_object(const Scene& scene, const Object& object, Mapping mapping) {
    const MappingBox box = mapping_box(scene, object, mapping);
    glm::dmat4 m(1);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) m[column][row] = box.axes[row][column] / box.extents[row];
        m[3][row] = -glm::dot(box.axes[row], box.center) / box.extents[row];
    }
    return m;
}

glm::dvec3 metres_per_mapping_unit(const Scene& scene, const Object& object, Mapping mapping) {
    return mapping_box(scene, object, mapping).extents;
}

SurfaceTable::SurfaceTable(const Scene& scene, std::span<const std::uint32_t> cubes) : scene_(scene), cubes_(cubes) {
    if (!cubes.empty()) cube_count_ = std::size_t{*std::ranges::max_element(cubes)} + 1;
    known_.resize(scene.materials.size() * cube_count_);
}

SurfaceTable::Known& SurfaceTable::known(std::uint32_t material, std::uint32_t object) {
    const bool mirrors = !cubes_.empty() && scene_.materials[material].environment > 0;
    return known_[material * cube_count_ + (mirrors ? cubes_[object] : 0)];
}

std::uint32_t SurfaceTable::add(std::uint32_t material, std::uint32_t object) {
    surfaces_.push_back({material, object});
    return static_cast<std::uint32_t>(surfaces_.size() - 1);
}

std::uint32_t SurfaceTable::number(std::uint32_t material, std::uint32_t object) {
    Known& known = this->known(material, object);
    if (known.object == object) return known.surface;
    known.object = object;
    if (depends_on_object(scene_.materials[material], scene_, scene_.objects[object])) return known.surface = add(material, object);
    if (known.shared == kUnknown) known.shared = add(material, object);
    return known.surface = known.shared;
}

} // namespace lightbench
