// Sidedness: what materials say, else whether the shape is closed and outward. In: an object. Out: whether both sides are drawn.
#include "scene/tessellate_sides.h"

#include "scene/surfaces.h"

#include <algorithm>

namespace lightbench {
namespace {

bool is_closed(const Shape& shape, const WeldedMesh* welded) {
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->capped;
    if (const auto* cone = std::get_if<Cone>(&shape)) return cone->capped;
    if (std::holds_alternative<MeshUse>(shape)) return welded->closed;
    return !std::holds_alternative<Polygon>(shape);
}

// What the materials of an object's faces say together: one that asks for both sides wins; all have to forbid them.
std::optional<bool> said_by_materials(const Scene& scene, const Object& object) {
    const auto* use = std::get_if<MeshUse>(&object.shape);
    if (!use || scene.meshes[use->mesh].face_materials.empty()) return scene.materials[object.material].two_sided;
    bool forbidden = true;
    for (std::uint32_t m : scene.meshes[use->mesh].face_materials) {
        const auto& said = scene.materials[m].two_sided;
        if (said.value_or(false)) return true;
        forbidden = forbidden && said.has_value();
    }
    return forbidden ? std::optional(false) : std::nullopt;
}

// Through a translucent face one sees the backs of the opaque faces around it, however closed the shape is.
bool has_window(const Scene& scene, const Object& object) {
    const auto* use = std::get_if<MeshUse>(&object.shape);
    if (!use) return false;
    const auto& materials = scene.meshes[use->mesh].face_materials;
    return std::any_of(materials.begin(), materials.end(), [&](std::uint32_t m) { return is_translucent(scene.materials[m]); });
}

} // namespace

bool is_two_sided(const Scene& scene, const Object& object, const WeldedMesh* welded) {
    if (const auto said = said_by_materials(scene, object)) return *said;
    return !is_closed(object.shape, welded) || has_window(scene, object);
}

bool is_two_sided(const Material& translucent) {
    return translucent.two_sided.value_or(true);
}

} // namespace lightbench
