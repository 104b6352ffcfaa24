// A scene as Haines' NFF (Haines 1987, "A Proposal for Standard Graphics Environments"). In: a Scene. Out: text, and what it cannot hold.
#include "scene/write_number.h"
#include "scene/write_parts.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace lightbench {
namespace {

constexpr const char* kInstead = "NFF has none; write .toml";

struct NffWriter {
    const Scene& scene;
    WriteLog& log;
    std::string out;
};

void line(NffWriter& w, std::string_view word, std::string_view rest) {
    w.out.append(word).append(" ").append(rest) += '\n';
}

// NFF needs a size: without one, that which the program would have taken.
void write_view(NffWriter& w) {
    if (w.scene.cameras.size() > 1) refuse(w.log, "a second camera", kInstead, "camera 2");
    if (w.scene.cameras.empty()) return;
    const Camera& c = w.scene.cameras.front();
    const glm::uvec2 size = w.scene.film.value_or(glm::uvec2(1280, 720));
    w.out += "v\n";
    line(w, "from", decimals(c.position, " "));
    line(w, "at", decimals(c.target, " "));
    line(w, "up", decimals(c.up, " "));
    line(w, "angle", decimal(degrees_for(c.fov)));
    if (c.hither > 0) line(w, "hither", decimal(c.hither));
    line(w, "resolution", fmt::format("{} {}", size.x, size.y));
}

void write_environment(NffWriter& w) {
    const Environment& e = w.scene.environment;
    if (e.ambient != glm::vec3(0)) refuse(w.log, "ambient light", kInstead, "environment");
    if (!e.map.empty()) refuse(w.log, "an environment map", kInstead, "environment");
    line(w, "b", decimals(e.background, " "));
}

void write_lights(NffWriter& w) {
    for (std::size_t i = 0; i < w.scene.lights.size(); ++i) {
        const Light& light = w.scene.lights[i];
        const std::string where = fmt::format("light {}", i + 1);
        if (light.type != LightType::point) refuse(w.log, "a light that is not a point light", kInstead, where);
        const bool attenuated = light.type != LightType::directional && light.attenuation != Attenuation::none;
        if (attenuated) refuse(w.log, "attenuation", "NFF's lights have none; write .toml", where);
        line(w, "l", fmt::format("{} {}", decimals(light.position, " "), decimals(light.intensity, " ")));
    }
}

bool grey(const glm::vec3& c) {
    return c.r == c.g && c.g == c.b;
}

// What `f` says of a material: kd = color * Kd, ks = kr = Ks, kt = T, shine where Ks > 0, the index where T > 0. The rest must be as usual.
Material as_nff_reads(const Material& m) {
    Material nff;
    nff.name = m.name;
    nff.diffuse = m.diffuse;
    nff.specular = m.specular;
    nff.shininess = m.shininess;
    nff.reflection = m.specular;
    nff.transmission = m.transmission;
    nff.ior = m.ior;
    return nff;
}

void write_fill(NffWriter& w, const Material& m) {
    Material meant = m;
    if (!meant.reflection) meant.reflection = m.specular; // their meaning when absent
    const bool one_index = grey(m.ior) || m.transmission == glm::vec3(0);
    if (meant != as_nff_reads(m) || !grey(m.specular) || !grey(m.transmission) || !one_index)
        refuse(w.log, "a material with more than a diffuse color and one Ks, shine, T and index", kInstead,
               fmt::format("material \"{}\"", m.name));
    const bool shiny = m.specular.r > 0, clear = m.transmission.r > 0;
    line(w, "f",
         fmt::format("{} 1 {} {} {} {}", decimals(m.diffuse, " "), decimal(m.specular.r), shiny ? decimal(m.shininess) : "0",
                     decimal(m.transmission.r), clear ? decimal(m.ior.r) : "0"));
}

void write_shape(NffWriter& w, const Sphere& s, std::string_view) {
    line(w, "s", fmt::format("{} {}", decimals(s.center, " "), decimal(s.radius)));
}

void write_shape(NffWriter& w, const Polygon& p, std::string_view) {
    line(w, p.normals.empty() ? "p" : "pp", std::to_string(p.points.size()));
    for (std::size_t i = 0; i < p.points.size(); ++i) {
        w.out += decimals(p.points[i], " ");
        if (!p.normals.empty()) (w.out += ' ') += decimals(p.normals[i], " ");
        w.out += '\n';
    }
}

void write_cone(NffWriter& w, const glm::dvec3& base, double base_radius, const glm::dvec3& top, double top_radius) {
    line(w, "c", fmt::format("{} {}", decimals(base, " "), decimal(base_radius)));
    (w.out += fmt::format("{} {}", decimals(top, " "), decimal(top_radius))) += '\n';
}

void write_shape(NffWriter& w, const Cylinder& c, std::string_view where) {
    if (c.capped) refuse(w.log, "a capped cylinder", "NFF's are open; write .toml", where);
    write_cone(w, c.base, c.radius, c.top, c.radius);
}

void write_shape(NffWriter& w, const Cone& c, std::string_view where) {
    if (c.capped) refuse(w.log, "a capped cone", "NFF's are open; write .toml", where);
    if (c.base_radius == c.top_radius) refuse(w.log, "a cone of equal radii", "it would be read as a cylinder", where);
    write_cone(w, c.base, c.base_radius, c.top, c.top_radius);
}

void write_shape(NffWriter& w, const Box&, std::string_view where) {
    refuse(w.log, "a box", kInstead, where);
}
void write_shape(NffWriter& w, const Torus&, std::string_view where) {
    refuse(w.log, "a torus", kInstead, where);
}
void write_shape(NffWriter& w, const MeshUse&, std::string_view where) {
    refuse(w.log, "a mesh", "NFF has polygons alone; write .toml", where);
}

void write_objects(NffWriter& w) {
    std::optional<std::uint32_t> material;
    for (std::size_t i = 0; i < w.scene.objects.size(); ++i) {
        const Object& object = w.scene.objects[i];
        const std::string where = fmt::format("object {}", i + 1);
        if (object.transform != 0) refuse(w.log, "a transform", kInstead, where);
        if (object.subdivide != 0) refuse(w.log, "a subdivision", kInstead, where);
        if (material != object.material) write_fill(w, w.scene.materials[object.material]);
        material = object.material;
        std::visit([&](const auto& shape) { write_shape(w, shape, where); }, object.shape);
    }
}

} // namespace

std::string nff_text(const Scene& scene, std::string_view comment, WriteLog& log) {
    NffWriter w{scene, log, {}};
    w.out = comment_lines(comment);
    write_environment(w);
    write_view(w);
    write_lights(w);
    write_objects(w);
    return std::move(w.out);
}

} // namespace lightbench
