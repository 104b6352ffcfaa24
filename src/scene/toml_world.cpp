// [film] [camera] [environment] [[light]]: everything that is neither a material nor an object.
#include "scene/check_geometry.h"
#include "scene/toml_parts.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

namespace lightbench {
namespace {

constexpr Rule kFov{0, 180, true, true, "it must lie between 0 and 180 degrees, both excluded"};
constexpr Rule kHalfAngle{0, 90, true, false, "it is the half-angle of the cone and must be greater than 0 and at most 90 degrees"};
constexpr Rule kHither{0, limits::kMaxCoordinate, false, false, "it must lie between 0 and 1e15 (limit kMaxCoordinate)"};

double radians(double degrees) {
    return degrees * (glm::pi<double>() / 180);
}

void check_view(const Section& s, const Camera& camera) {
    if (has_no_direction(camera)) {
        fault(s, place_of(s, "target"), "target is the same point as position; the camera must look somewhere");
    } else if (up_is_along_view(camera)) {
        const auto& up = camera.up;
        fault(s, place_of(s, "up"),
              fmt::format("up is [{}, {}, {}], along the view direction; it must point to another side", up.x, up.y, up.z));
    }
}

std::string camera_name(TomlLoad& load, Section& s) {
    std::string name;
    if (!read_name(s, "name", name)) return fmt::format("camera {}", load.scene.cameras.size() + 1);
    s.who = fmt::format("camera {}", in_quotes(name));
    for (const Camera& other : load.scene.cameras)
        if (other.name == name) fault(s, *s.table->get("name"), "another camera has this name; names must differ");
    return name;
}

// Keys that mean nothing for this type of light are a remark: a file switched from spot to point need not be cut down.
void remark_unused(TomlLoad& load, const Section& s, std::string_view type, std::span<const std::string_view> keys) {
    for (std::string_view key : keys)
        if (const toml::node* node = s.table->get(key))
            load.scene.remarks.push_back(fmt::format("light at line {}: a {} light has no {}", node->source().begin.line, type, key));
}

void read_light_direction(Section& s, Light& light) {
    if (!s.table->get("direction")) {
        find(s, "direction");
        return fault(s, s.table->source(), "direction is missing; give [x, y, z], the way the light travels");
    }
    glm::dvec3 d(0);
    if (!read_vector(s, "direction", d, kCoordinate)) return;
    if (!(glm::length(d) > 0)) return fault(s, place_of(s, "direction"), "direction is [0, 0, 0]; it must point somewhere");
    light.direction = glm::normalize(d);
}

void read_light_position(Section& s, Light& light) {
    if (read_vector(s, "position", light.position, kCoordinate) || s.table->get("position")) return;
    fault(s, s.table->source(), "position is missing; give [x, y, z]");
}

void read_light_place(TomlLoad& load, Section& s, Light& light) {
    constexpr std::string_view kPointless[] = {"direction", "angle", "softness"}, kDirectionless[] = {"position", "angle", "softness"};
    if (light.type != LightType::directional)
        read_light_position(s, light);
    else
        find(s, "position");
    if (light.type != LightType::point)
        read_light_direction(s, light);
    else
        find(s, "direction");
    if (light.type == LightType::point) remark_unused(load, s, "point", kPointless);
    if (light.type == LightType::directional) remark_unused(load, s, "directional", kDirectionless);
}

// Ip = color * intensity; either may be a number or a color.
void read_intensity(Section& s, Light& light) {
    glm::vec3 color(1), intensity(1);
    read_color(s, "color", color, kNotNegative);
    read_color(s, "intensity", intensity, kNotNegative);
    light.intensity = color * intensity;
    const float most = std::max({light.intensity.r, light.intensity.g, light.intensity.b});
    if (!(most <= FLT_MAX)) fault(s, place_of(s, "intensity"), "color times intensity is too large; it must be at most 3.4e38");
}

std::vector<std::uint32_t> read_map(TomlLoad& load, Section& s) {
    const toml::node* node = find(s, "map");
    std::filesystem::path path;
    if (!node) return {};
    const toml::array* faces = node->as_array();
    if (!faces) return file_of(load, s, *node, "map", path) ? std::vector{picture_index(load, path)} : std::vector<std::uint32_t>{};
    std::vector<std::uint32_t> pictures;
    for (const toml::node& face : *faces)
        if (file_of(load, s, face, "map", path)) pictures.push_back(picture_index(load, path));
    if (faces->size() != 6)
        fault(s, *node, fmt::format("map has {} faces; it must be one file or six: +x, -x, +y, -y, +z, -z", faces->size()));
    return pictures;
}

} // namespace

void read_film(TomlLoad& load, const toml::table& table) {
    Section s = section_of(load, table, "film");
    glm::uvec2 size(0);
    const bool width = read_whole(s, "width", size.x, 1, limits::kMaxImageSide),
               height = read_whole(s, "height", size.y, 1, limits::kMaxImageSide);
    if (!table.get("width")) fault(s, table.source(), "width is missing; give it in pixels");
    if (!table.get("height")) fault(s, table.source(), "height is missing; give it in pixels");
    if (width && height) load.scene.film = size;
    report_unknown_keys(s);
}

void read_camera(TomlLoad& load, const toml::table& table) {
    Section s = section_of(load, table, "camera");
    Camera camera;
    camera.name = camera_name(load, s);
    double fov = 45;
    const bool position = read_vector(s, "position", camera.position, kCoordinate) || !table.get("position");
    const bool target = read_vector(s, "target", camera.target, kCoordinate) || !table.get("target");
    const bool up = read_vector(s, "up", camera.up, kCoordinate) || !table.get("up");
    if (position && target && up) check_view(s, camera);
    read(s, "fov", fov, kFov);
    camera.fov = radians(fov);
    read(s, "hither", camera.hither, kHither);
    report_unknown_keys(s);
    load.scene.cameras.push_back(camera);
}

void read_environment(TomlLoad& load, const toml::table& table) {
    Section s = section_of(load, table, "environment");
    Environment& e = load.scene.environment;
    read_color(s, "background", e.background, kNotNegative);
    read_color(s, "ambient", e.ambient, kNotNegative);
    e.map = read_map(load, s);
    report_unknown_keys(s);
}

void read_light(TomlLoad& load, const toml::table& table) {
    constexpr std::string_view kTypes[] = {"point", "directional", "spot"}, kLaws[] = {"none", "linear", "inverse-square"};
    Section s = section_of(load, table, "light");
    Light light;
    const std::size_t type = read_choice(s, "type", kTypes);
    if (type < 3) light.type = static_cast<LightType>(type);
    read_light_place(load, s, light);
    read_intensity(s, light);
    if (const std::size_t law = read_choice(s, "attenuation", kLaws); law < 3) light.attenuation = static_cast<Attenuation>(law);
    read(s, "d0", light.d0, kLength);
    double degrees = 0;
    if (read(s, "angle", degrees, kHalfAngle)) light.angle = radians(degrees);
    read(s, "softness", light.softness, kFraction);
    report_unknown_keys(s);
    load.scene.lights.push_back(light);
}

} // namespace lightbench
