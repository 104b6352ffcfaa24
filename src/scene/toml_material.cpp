// [[material]]: every coefficient of the illumination model with its range, texture, bump.
#include "scene/toml_parts.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr Rule kOpacity{0, 1, false, false, "it must lie between 0 (invisible) and 1 (opaque)"};
constexpr Rule kF0{0, 1, false, true, "it must be at least 0 and less than 1 (the index of refraction is infinite there)"};
constexpr Rule kExponent{0, kLargestFloat, false, false, "it must be 0 (a broad highlight) or greater, and at most 3.4e38"};
constexpr Rule kSlope{0, kLargestFloat, true, false, "it is the rms slope of the facets and must be greater than 0"};

// A name is needed, for objects refer to it; where it is wrong the rest is read all the same, for its problems.
std::string material_name(TomlLoad& load, Section& s) {
    std::string name;
    const bool given = read_name(s, "name", name);
    if (!s.table->get("name")) fault(s, s.table->source(), "name is missing; objects refer to it");
    if (!given) return name;
    s.who = fmt::format("material {}", in_quotes(name));
    const toml::node& node = *s.table->get("name");
    if (name.empty()) fault(s, node, "the name is empty; objects refer to it");
    const auto [first, added] = load.material_lines.try_emplace(name, node.source().begin.line);
    if (!added) fault(s, node, fmt::format("the material at line {} has this name; names must differ", first->second));
    return name;
}

// Cauchy's n = A + B / lambda^2 [micrometres]. B alone: A is chosen so that the index at 0.55 is `ior`.
void read_dispersion(Section& s, Material& m) {
    const toml::node* node = s.table->get("dispersion");
    glm::dvec2 ab(0);
    if (!read_pair(s, "dispersion", ab, kAnyFloat)) return;
    if (!node->is_array()) ab.x = static_cast<double>(m.ior.g) - ab.y / (0.55 * 0.55);
    for (double lambda : {0.65, 0.55, 0.45}) {
        const double index = ab.x + ab.y / (lambda * lambda);
        if (index > 0) continue;
        return fault(
            s, *node,
            fmt::format("dispersion makes the index of refraction {} at {} micrometres; it must be greater than 0", index, lambda));
    }
    m.dispersion = ab;
}

const toml::table* sub_table(Section& s, std::string_view key, std::string_view example) {
    const toml::node* node = find(s, key);
    if (node && !node->is_table()) fault(s, *node, fmt::format("{} is {}; write {}", key, kind_name(*node), example));
    return node ? node->as_table() : nullptr;
}

void read_texture(TomlLoad& load, Section& material, Material& m) {
    constexpr std::string_view kMappings[] = {"uv", "spherical", "cylindrical", "planar"};
    const toml::table* table = sub_table(material, "texture", "texture = {file = \"wood.png\"} or {checker = true}");
    if (!table) return;
    Section s = section_of(load, *table, material.who + ": texture");
    Texture texture;
    std::filesystem::path path;
    bool checker = false;
    if (read_file_name(load, s, "file", path)) texture.picture = picture_index(load, path);
    read(s, "checker", checker);
    if (table->get("file") && checker) fault(s, *table, "both file and checker; give one of them");
    if (!table->get("file") && !checker && !(table->get("checker") && !table->get("checker")->is_boolean()))
        fault(s, *table, "neither file nor checker; give one of them");
    if (const std::size_t mapping = read_choice(s, "mapping", kMappings); mapping < 4) texture.mapping = static_cast<Mapping>(mapping);
    read_pair(s, "scale", texture.scale, kPositive);
    report_unknown_keys(s);
    m.texture = texture;
}

void read_bump(TomlLoad& load, Section& material, Material& m) {
    constexpr std::string_view kFunctions[] = {"waves", "noise"};
    const toml::table* table =
        sub_table(material, "bump", "bump = {function = \"waves\", amplitude = 0.01, frequency = 1} or {file = \"height.png\"}");
    if (!table) return;
    Section s = section_of(load, *table, material.who + ": bump");
    Bump bump;
    std::filesystem::path path;
    if (read_file_name(load, s, "file", path)) bump.picture = picture_index(load, path);
    if (const std::size_t function = read_choice(s, "function", kFunctions); function < 2)
        bump.function = function == 0 ? BumpFunction::waves : BumpFunction::noise;
    if (table->get("file") && table->get("function")) fault(s, *table, "both file and function; give one of them");
    if (!table->get("file") && !table->get("function")) fault(s, *table, "neither file nor function; give one of them");
    read(s, "normal_map", bump.normal_map);
    if (bump.normal_map && !table->get("file")) fault(s, *table->get("normal_map"), "a normal map needs a file");
    read(s, "amplitude", bump.amplitude, kCoordinate);
    read(s, "frequency", bump.frequency, kLength);
    report_unknown_keys(s);
    m.bump = bump;
}

void read_highlight(Section& s, Material& m) {
    constexpr std::string_view kModels[] = {"phong", "cook-torrance"}, kDistributions[] = {"gaussian", "beckmann"};
    read_color(s, "specular", m.specular, kFraction);
    read(s, "shininess", m.shininess, kExponent);
    if (const std::size_t model = read_choice(s, "model", kModels); model < 2) m.model = static_cast<Model>(model);
    if (const std::size_t d = read_choice(s, "distribution", kDistributions); d < 2) m.distribution = static_cast<Distribution>(d);
    read(s, "roughness", m.roughness, kSlope);
    if (glm::vec3 f0(0); read_color(s, "f0", f0, kF0)) m.f0 = f0;
}

void read_rays(Section& s, Material& m) {
    read_color(s, "ior", m.ior, kPositive);
    read(s, "fresnel", m.fresnel);
    if (glm::vec3 kr(0); read_color(s, "reflection", kr, kFraction)) m.reflection = kr;
    read_color(s, "transmission", m.transmission, kFraction);
    read(s, "scatter", m.scatter, kNotNegative);
    read_dispersion(s, m);
    read_color(s, "opacity", m.opacity, kOpacity);
    read(s, "environment", m.environment, kFraction);
}

} // namespace

void read_material(TomlLoad& load, const toml::table& table) {
    Section s = section_of(load, table, "material");
    Material m;
    m.name = material_name(load, s);
    read_color(s, "diffuse", m.diffuse, kFraction);
    read_highlight(s, m);
    read_rays(s, m);
    read_color(s, "emission", m.emission, kNotNegative);
    if (bool two_sided = false; read(s, "two_sided", two_sided)) m.two_sided = two_sided;
    read_texture(load, s, m);
    read_bump(load, s, m);
    report_unknown_keys(s);
    load.materials.try_emplace(m.name, static_cast<std::uint32_t>(load.scene.materials.size()));
    load.scene.materials.push_back(std::move(m));
}

} // namespace lightbench
