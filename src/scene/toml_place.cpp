// Imported files as objects of a native scene: read once, placed any number of times.
#include "scene/import.h"
#include "scene/nff.h"
#include "scene/paths.h"
#include "scene/toml_parts.h"

#include <fmt/format.h>
#include <unordered_map>

namespace lightbench {
namespace {

bool is_nff(const std::filesystem::path& path) {
    const std::string e = path.extension().string();
    return e.size() == 4 && e[0] == '.' && (e[1] | 32) == 'n' && (e[2] | 32) == 'f' && (e[3] | 32) == 'f';
}

std::optional<Loaded> load_part(TomlLoad& load, const std::filesystem::path& path) {
    if (is_nff(path)) return load_nff(path, load.options);
    if (is_imported_format(path)) return import_file(path, load.options, load.folder);
    return std::nullopt;
}

void move_shape(Object& object, std::uint32_t meshes) {
    if (auto* use = std::get_if<MeshUse>(&object.shape)) use->mesh += meshes;
}

void move_pictures(Material& m, std::uint32_t pictures) {
    if (m.texture && m.texture->picture) *m.texture->picture += pictures;
    if (m.bump && m.bump->picture) *m.bump->picture += pictures;
}

template <class T> std::uint32_t append(std::vector<T>& to, std::vector<T>& from) {
    const auto first = static_cast<std::uint32_t>(to.size());
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    return first;
}

void remark_unused(Scene& scene, const Scene& part) {
    for (const std::string& remark : part.remarks) scene.remarks.push_back(fmt::format("{}: {}", part.name, remark));
    if (!part.lights.empty())
        scene.remarks.push_back(
            fmt::format("{}: its {} lights are left out; a placed file gives objects only", part.name, part.lights.size()));
    if (!part.cameras.empty())
        scene.remarks.push_back(
            fmt::format("{}: its {} cameras are left out; a placed file gives objects only", part.name, part.cameras.size()));
}

// Everything but the objects becomes part of the scene; the objects wait, with indices of the whole scene.
Placed absorb(Scene& scene, Scene part) {
    remark_unused(scene, part);
    const std::uint32_t pictures = append(scene.pictures, part.pictures);
    for (Material& m : part.materials) move_pictures(m, pictures);
    const std::uint32_t materials = append(scene.materials, part.materials);
    for (Mesh& mesh : part.meshes)
        for (std::uint32_t& m : mesh.face_materials) m += materials;
    const std::uint32_t meshes = append(scene.meshes, part.meshes);
    const std::uint32_t transforms = append(scene.transforms, part.transforms);
    for (Object& object : part.objects) {
        object.material += materials;
        object.transform = object.transform == 0 ? 0 : object.transform + transforms;
        move_shape(object, meshes);
    }
    return {std::move(part.objects), {}, true};
}

// Reads the file if it is new. Null: it cannot be used, which has been reported.
Placed* placed_file(TomlLoad& load, const Section& s, const toml::node& where, const std::filesystem::path& path) {
    const auto [entry, added] = load.placed.try_emplace(path.string());
    Placed& placed = entry->second;
    if (!added) return placed.usable ? &placed : nullptr;
    if (load.placed.size() > limits::kMaxIncludes) {
        fault(s, where, fmt::format("a scene places at most {} files (limit kMaxIncludes)", limits::kMaxIncludes));
        return nullptr;
    }
    std::optional<Loaded> loaded = load_part(load, path);
    if (!loaded) {
        fault(s, where,
              fmt::format("{}: this format cannot be placed; it must be .nff .obj .gltf .glb .ply or .stl",
                          in_quotes(path.filename().string())));
        return nullptr;
    }
    report_all(load.log, loaded->problems);
    if (loaded->scene) placed = absorb(load.scene, std::move(*loaded->scene));
    return placed.usable ? &placed : nullptr;
}

// A mesh whose faces have materials of their own, made to obey its object's.
std::uint32_t without_materials(Scene& scene, Placed& placed, std::uint32_t mesh) {
    if (scene.meshes[mesh].face_materials.empty()) return mesh;
    const auto [entry, added] = placed.plain.try_emplace(mesh, static_cast<std::uint32_t>(scene.meshes.size()));
    if (added) {
        Mesh copy = scene.meshes[mesh];
        copy.face_materials.clear();
        scene.meshes.push_back(std::move(copy));
    }
    return entry->second;
}

void apply(Scene& scene, Placed& placed, Object& object, const Placing& placing) {
    object.crease = placing.crease.value_or(object.crease);
    object.subdivide = placing.subdivide.value_or(object.subdivide);
    if (!placing.material) return;
    object.material = *placing.material;
    if (auto* use = std::get_if<MeshUse>(&object.shape)) use->mesh = without_materials(scene, placed, use->mesh);
}

// world_from_part * part_from_object, one new transform for each that the part uses.
std::uint32_t composed(Scene& scene, std::unordered_map<std::uint32_t, std::uint32_t>& known, std::uint32_t outer, std::uint32_t inner) {
    if (outer == 0) return inner;
    if (inner == 0) return outer;
    const auto [entry, added] = known.try_emplace(inner, static_cast<std::uint32_t>(scene.transforms.size()));
    if (added) scene.transforms.push_back(glm::dmat4(scene.transforms[outer] * scene.transforms[inner]));
    return entry->second;
}

} // namespace

void place_file(TomlLoad& load, const Section& s, const toml::node& where, const std::filesystem::path& path, const Placing& placing) {
    Placed* placed = placed_file(load, s, where, path);
    if (!placed) return;
    Scene& scene = load.scene;
    if (scene.objects.size() + placed->objects.size() > limits::kMaxObjects)
        return fault(s, where, fmt::format("more than {} objects (limit kMaxObjects)", limits::kMaxObjects));
    std::unordered_map<std::uint32_t, std::uint32_t> transforms;
    for (Object object : placed->objects) {
        object.transform = composed(scene, transforms, placing.transform, object.transform);
        apply(scene, *placed, object, placing);
        scene.objects.push_back(std::move(object));
    }
}

} // namespace lightbench
