// [[object]]: shape, material, transform; an imported file stands in for a shape.
#include "scene/load_default.h"
#include "scene/toml_parts.h"
#include "scene/transform.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/constants.hpp>

namespace lightbench {
namespace {

constexpr std::string_view kShapes[] = {"sphere", "polygon", "mesh", "cone", "box", "cylinder", "torus"};
constexpr Rule kDegrees{-1e9, 1e9, false, false,
                        "it must lie between -1e9 and 1e9 degrees (beyond that a double holds no fraction worth the name)"};
constexpr Rule kCrease{0, 180, false, false, "it must lie between 0 and 180 degrees"};

// Below 1e-15 or above 1e15 the inverse leaves the range of coordinates; 0 would flatten the object.
void check_scale(Section& s, const glm::dvec3& scale) {
    constexpr double kMost = limits::kMaxCoordinate, kLeast = 1 / limits::kMaxCoordinate;
    for (int i = 0; i < 3; ++i) {
        const double size = std::abs(scale[i]);
        if (size >= kLeast && size <= kMost) continue;
        return fault(s, *s.table->get("scale"),
                     fmt::format("scale is {} along {}; its size must lie between 1e-15 and 1e15", scale[i], "xyz"[i]));
    }
}

glm::dvec3 read_scale(Section& s) {
    glm::dvec3 scale(1);
    double all = 1;
    const toml::node* node = s.table->get("scale");
    if (node && !node->is_array()) {
        if (read(s, "scale", all, kCoordinate)) scale = glm::dvec3(all);
    } else {
        read_vector(s, "scale", scale, kCoordinate);
    }
    if (node) check_scale(s, scale);
    return scale;
}

glm::dmat4 read_world_from_object(Section& s) {
    TransformParts placement;
    read_vector(s, "translate", placement.translate, kCoordinate);
    read_vector(s, "rotate", placement.rotate, kDegrees);
    placement.scale = read_scale(s);
    return world_from_object(placement);
}

std::uint32_t transform_index(Scene& scene, const glm::dmat4& world_from_object) {
    if (world_from_object == scene.transforms.front()) return 0;
    if (world_from_object != scene.transforms.back()) scene.transforms.push_back(world_from_object);
    return static_cast<std::uint32_t>(scene.transforms.size() - 1);
}

std::string nearest_material(const TomlLoad& load, std::string_view name) {
    constexpr std::size_t kSearched = 4096; // names are compared one by one, for each of up to max_problems problems
    if (full(load.log) || load.materials.size() > kSearched) return {};
    std::vector<std::string_view> names;
    for (const auto& [known, index] : load.materials) names.push_back(known);
    return did_you_mean(name, names);
}

std::optional<std::uint32_t> read_material_use(TomlLoad& load, Section& s) {
    std::string name;
    if (!read(s, "material", name)) return std::nullopt;
    const auto found = load.materials.find(name);
    if (found != load.materials.end()) return found->second;
    const std::string meant = nearest_material(load, name);
    fault(s, *s.table->get("material"),
          fmt::format("unknown material {}{}", in_quotes(name), meant.empty() ? "; no [[material]] has this name" : meant));
    return std::nullopt;
}

// The material of objects that name none.
std::uint32_t default_material_index(TomlLoad& load) {
    constexpr const char* kName = ""; // no [[material]] can have it
    const auto [entry, added] = load.materials.try_emplace(kName, static_cast<std::uint32_t>(load.scene.materials.size()));
    if (added) load.scene.materials.push_back(default_material());
    return entry->second;
}

void read_mesh(TomlLoad& load, Section& s, const Placing& placing) {
    std::filesystem::path path;
    if (!s.table->get("file")) fault(s, s.table->source(), "file is missing; give the mesh's file name");
    if (read_file_name(load, s, "file", path)) place_file(load, s, *s.table->get("file"), path, placing);
}

void add_object(TomlLoad& load, Shape shape, const Placing& placing) {
    Object object;
    object.shape = std::move(shape);
    object.material = placing.material ? *placing.material : default_material_index(load);
    object.transform = placing.transform;
    object.crease = placing.crease.value_or(object.crease);
    object.subdivide = placing.subdivide.value_or(object.subdivide);
    load.scene.objects.push_back(std::move(object));
}

} // namespace

void read_object(TomlLoad& load, const toml::table& table) {
    Section s = section_of(load, table, "object");
    if (!table.get("shape")) fault(s, table.source(), fmt::format("shape is missing; it must be one of {}", fmt::join(kShapes, ", ")));
    const std::size_t shape = read_choice(s, "shape", kShapes);
    Placing placing;
    placing.material = read_material_use(load, s);
    placing.transform = transform_index(load.scene, read_world_from_object(s));
    if (double degrees = 0; read(s, "crease", degrees, kCrease)) placing.crease = static_cast<float>(degrees * (glm::pi<double>() / 180));
    if (unsigned levels = 0; read_whole(s, "subdivide", levels, 0, 8)) placing.subdivide = static_cast<std::uint8_t>(levels);
    if (shape >= std::size(kShapes)) return; // which keys it takes is not known
    Shape read;
    if (kShapes[shape] == "mesh")
        read_mesh(load, s, placing);
    else if (read_shape(s, kShapes[shape], read))
        add_object(load, std::move(read), placing);
    report_unknown_keys(s);
}

} // namespace lightbench
