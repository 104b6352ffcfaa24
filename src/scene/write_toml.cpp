// A scene as TOML: every field that differs from its default, under the keys of the native format. In: a Scene. Out: text, and what it cannot hold.
#include "scene/write_toml.h"

#include "scene/limits.h"
#include "scene/write_number.h"

#include <fmt/format.h>
#include <set>

namespace lightbench {
namespace {

void write_film(TomlWriter& w) {
    if (!w.scene.film) return;
    begin_section(w, "[film]");
    key(w, "width", std::to_string(w.scene.film->x));
    key(w, "height", std::to_string(w.scene.film->y));
}

void write_camera(TomlWriter& w, const Camera& camera) {
    const Camera usual;
    begin_section(w, "[[camera]]");
    if (!camera.name.empty()) key(w, "name", quoted_toml(camera.name));
    key(w, "position", toml(camera.position));
    key(w, "target", toml(camera.target));
    if (camera.up != usual.up) key(w, "up", toml(camera.up));
    if (camera.fov != usual.fov) key(w, "fov", decimal(degrees_for(camera.fov)));
    if (camera.hither != usual.hither) key(w, "hither", decimal(camera.hither));
}

void write_environment(TomlWriter& w) {
    const Environment& e = w.scene.environment;
    const glm::vec3 none(0);
    if (e.background == none && e.ambient == none && e.map.empty()) return;
    begin_section(w, "[environment]");
    if (e.background != none) key(w, "background", toml_color(e.background));
    if (e.ambient != none) key(w, "ambient", toml_color(e.ambient));
    std::string faces;
    for (const std::uint32_t picture : e.map)
        faces += fmt::format("{}{}", faces.empty() ? "" : ", ", picture_name(w, picture, "environment"));
    if (!e.map.empty()) key(w, "map", e.map.size() == 1 ? faces : fmt::format("[{}]", faces));
}

// Only the keys that mean something for this type of light: the others are remarks when read.
void write_light(TomlWriter& w, const Light& light) {
    constexpr const char* kTypes[] = {"point", "directional", "spot"};
    constexpr const char* kLaws[] = {"none", "linear", "inverse-square"};
    const Light usual;
    begin_section(w, "[[light]]");
    key(w, "type", fmt::format("\"{}\"", kTypes[static_cast<std::size_t>(light.type)]));
    if (light.type != LightType::directional) key(w, "position", toml(light.position));
    if (light.type != LightType::point) key(w, "direction", toml(light.direction));
    if (light.intensity != usual.intensity) key(w, "intensity", toml_color(light.intensity));
    if (light.attenuation != usual.attenuation)
        key(w, "attenuation", fmt::format("\"{}\"", kLaws[static_cast<std::size_t>(light.attenuation)]));
    if (light.d0 != usual.d0) key(w, "d0", decimal(light.d0));
    if (light.type != LightType::spot) return;
    if (light.angle != usual.angle) key(w, "angle", decimal(degrees_for(light.angle)));
    if (light.softness != usual.softness) key(w, "softness", decimal(light.softness));
}

// Objects refer to materials by name: one that is missing or already taken is replaced by a number that nobody has.
std::vector<std::string> usable_names(const Scene& scene) {
    std::set<std::string> taken;
    for (const Material& m : scene.materials) taken.insert(m.name);
    std::set<std::string_view> given;
    std::vector<std::string> names;
    for (const Material& m : scene.materials) {
        std::string name = m.name;
        if (name.empty() || !given.insert(m.name).second)
            for (std::size_t n = names.size() + 1; !taken.insert(name = fmt::format("material-{}", n)).second;) ++n;
        names.push_back(std::move(name));
    }
    return names;
}

} // namespace

void begin_section(TomlWriter& w, std::string_view head) {
    if (!w.out.empty()) w.out += '\n';
    w.out.append(head) += '\n';
}

void key(TomlWriter& w, std::string_view name, std::string_view value) {
    w.out.append(name).append(" = ").append(value) += '\n';
}

std::string toml(const glm::dvec3& v) {
    return fmt::format("[{}]", decimals(v, ", "));
}

std::string toml_color(const glm::vec3& c) {
    return c.r == c.g && c.g == c.b ? decimal(c.r) : fmt::format("[{}]", decimals(c, ", "));
}

// TOML 1.0: a basic string escapes quotes, backslashes and control characters.
std::string quoted_toml(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            (out += '\\') += c;
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out += '"';
}

std::string picture_name(TomlWriter& w, std::uint32_t index, std::string_view where) {
    const Picture& picture = w.scene.pictures[index];
    const auto name = picture.file.lexically_proximate(w.file.parent_path());
    if (!picture.encoded.empty())
        refuse(w.log, "a picture that is embedded in an imported file", "save it as a file first", where);
    else if (name.is_absolute() || *name.begin() == "..")
        refuse(w.log, fmt::format("the picture {}", picture.file.string()), "it must lie in the folder of the scene", where);
    return quoted_toml(name.generic_string());
}

std::string toml_text(const Scene& scene, const std::filesystem::path& file, std::string_view comment, WriteLog& log) {
    TomlWriter w{scene, file, log, {}, usable_names(scene)};
    w.out = comment_lines(comment);
    write_film(w);
    for (const Camera& camera : scene.cameras) write_camera(w, camera);
    write_environment(w);
    for (const Light& light : scene.lights) write_light(w, light);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) write_material(w, i);
    if (scene.meshes.size() > limits::kMaxIncludes)
        refuse(log, fmt::format("a scene of {} meshes", scene.meshes.size()),
               fmt::format("a TOML scene places at most {} files (limit kMaxIncludes)", limits::kMaxIncludes), "");
    for (std::size_t i = 0; i < scene.objects.size(); ++i) write_object(w, i);
    return std::move(w.out);
}

} // namespace lightbench
