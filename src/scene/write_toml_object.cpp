// [[object]] as text: the shape's keys, the material's name, the transform taken apart.
#include "scene/transform.h"
#include "scene/write_number.h"
#include "scene/write_toml.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

// A list of points, one a line where they are many.
template <typename Vector> std::string list_of(const std::vector<Vector>& points) {
    const char* separator = points.size() > 4 ? ",\n    " : ", ";
    std::string out = points.size() > 4 ? "[\n    " : "[";
    for (std::size_t i = 0; i < points.size(); ++i) out += fmt::format("{}[{}]", i ? separator : "", decimals(points[i], ", "));
    return out + (points.size() > 4 ? ",\n]" : "]");
}

void shape_keys(TomlWriter& w, const Sphere& s) {
    key(w, "shape", "\"sphere\"");
    key(w, "center", toml(s.center));
    key(w, "radius", decimal(s.radius));
}

void shape_keys(TomlWriter& w, const Polygon& p) {
    key(w, "shape", "\"polygon\"");
    key(w, "points", list_of(p.points));
    if (!p.normals.empty()) key(w, "normals", list_of(p.normals));
}

void shape_keys(TomlWriter& w, const Box& b) {
    key(w, "shape", "\"box\"");
    key(w, "min", toml(b.min));
    key(w, "max", toml(b.max));
}

void shape_keys(TomlWriter& w, const Cylinder& c) {
    key(w, "shape", "\"cylinder\"");
    key(w, "base", toml(c.base));
    key(w, "top", toml(c.top));
    key(w, "radius", decimal(c.radius));
    if (!c.capped) key(w, "capped", "false");
}

void shape_keys(TomlWriter& w, const Cone& c) {
    key(w, "shape", "\"cone\"");
    key(w, "base", toml(c.base));
    key(w, c.top_radius == 0 ? "apex" : "top", toml(c.top));
    key(w, "base_radius", decimal(c.base_radius));
    if (c.top_radius != 0) key(w, "top_radius", decimal(c.top_radius));
    if (!c.capped) key(w, "capped", "false");
}

void shape_keys(TomlWriter& w, const Torus& t) {
    key(w, "shape", "\"torus\"");
    key(w, "center", toml(t.center));
    if (t.axis != Torus{}.axis) key(w, "axis", toml(t.axis));
    key(w, "major", decimal(t.major));
    key(w, "minor", decimal(t.minor));
}

void shape_keys(TomlWriter& w, const MeshUse& use) {
    key(w, "shape", "\"mesh\"");
    key(w, "file", quoted_toml(mesh_file(w.scene, use.mesh, w.file).filename().generic_string()));
    if (!w.scene.meshes[use.mesh].face_materials.empty())
        refuse(w.log, "a mesh with a material for each face", "split it into a mesh for each material",
               fmt::format("mesh \"{}\"", w.scene.meshes[use.mesh].name));
    if (!w.scene.meshes[use.mesh].tangents.empty())
        refuse(w.log, "a mesh with tangents", "OBJ and PLY have none; leave them out, and they follow from its uv",
               fmt::format("mesh \"{}\"", w.scene.meshes[use.mesh].name));
}

void write_placement(TomlWriter& w, const glm::dmat4& world_from_object, std::string_view where) {
    const auto p = transform_parts(world_from_object);
    if (!p) return refuse(w.log, "a transform that shears or flattens", "it must be translate * rotate * scale", where);
    if (p->translate != glm::dvec3(0)) key(w, "translate", toml(p->translate));
    if (p->rotate != glm::dvec3(0)) key(w, "rotate", toml(p->rotate));
    const bool even = p->scale.x == p->scale.y && p->scale.y == p->scale.z;
    if (p->scale != glm::dvec3(1)) key(w, "scale", even ? decimal(p->scale.x) : toml(p->scale));
}

} // namespace

void write_object(TomlWriter& w, std::size_t index) {
    const Object& object = w.scene.objects[index];
    const Object usual;
    begin_section(w, "[[object]]");
    std::visit([&](const auto& shape) { shape_keys(w, shape); }, object.shape);
    key(w, "material", quoted_toml(w.materials[object.material]));
    if (object.transform != 0) write_placement(w, w.scene.transforms[object.transform], fmt::format("object {}", index + 1));
    // An imported file may have a crease angle of its own, so a mesh always says its own.
    const bool mesh = std::holds_alternative<MeshUse>(object.shape);
    if (mesh || object.crease != usual.crease) key(w, "crease", decimal(degrees_for(object.crease)));
    if (object.subdivide != 0) key(w, "subdivide", std::to_string(object.subdivide));
}

} // namespace lightbench
