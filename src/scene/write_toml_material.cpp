// [[material]] as text.
#include "scene/write_number.h"
#include "scene/write_toml.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

std::string pair_of(const glm::dvec2& v) {
    return v.x == v.y ? decimal(v.x) : fmt::format("[{}, {}]", decimal(v.x), decimal(v.y));
}

std::string texture_text(TomlWriter& w, const Texture& t, std::string_view where) {
    constexpr const char* kMappings[] = {"uv", "spherical", "cylindrical", "planar"};
    std::string out = t.picture ? "{file = " + picture_name(w, *t.picture, where) : "{checker = true";
    if (t.mapping != Mapping::uv) out += fmt::format(", mapping = \"{}\"", kMappings[static_cast<std::size_t>(t.mapping)]);
    if (t.wrap_u != Wrap::repeat || t.wrap_v != Wrap::repeat)
        refuse(w.log, "a texture that clamps or mirrors", "textures of this format repeat", where);
    if (t.alpha) refuse(w.log, "a texture whose alpha is opacity", "opacity of this format is the material's", where);
    if (t.scale != glm::dvec2(1)) out += ", scale = " + pair_of(t.scale);
    return out + "}";
}

std::string bump_text(TomlWriter& w, const Bump& b, std::string_view where) {
    const Bump usual;
    std::string out;
    if (b.picture)
        out = "{file = " + picture_name(w, *b.picture, where);
    else if (b.function == BumpFunction::none)
        refuse(w.log, "a bump without function or picture", "it has no effect; leave it out", where);
    else
        out = fmt::format("{{function = \"{}\"", b.function == BumpFunction::waves ? "waves" : "noise");
    if (b.normal_map) out += ", normal_map = true";
    if (b.amplitude != usual.amplitude) out += ", amplitude = " + decimal(b.amplitude);
    if (b.frequency != usual.frequency) out += ", frequency = " + decimal(b.frequency);
    return out + "}";
}

void write_highlight(TomlWriter& w, const Material& m, const Material& usual) {
    if (m.specular != usual.specular) key(w, "specular", toml_color(m.specular));
    if (m.shininess != usual.shininess) key(w, "shininess", decimal(m.shininess));
    if (m.model == Model::cook_torrance) key(w, "model", "\"cook-torrance\"");
    if (m.distribution == Distribution::beckmann) key(w, "distribution", "\"beckmann\"");
    if (m.roughness != usual.roughness) key(w, "roughness", decimal(m.roughness));
    if (m.f0) key(w, "f0", toml_color(*m.f0));
}

void write_rays(TomlWriter& w, const Material& m, const Material& usual) {
    if (m.ior != usual.ior) key(w, "ior", toml_color(m.ior));
    if (m.fresnel) key(w, "fresnel", "true");
    if (m.reflection) key(w, "reflection", toml_color(*m.reflection));
    if (m.transmission != usual.transmission) key(w, "transmission", toml_color(m.transmission));
    if (m.scatter != usual.scatter) key(w, "scatter", decimal(m.scatter));
    if (m.dispersion != usual.dispersion) key(w, "dispersion", fmt::format("[{}, {}]", decimal(m.dispersion.x), decimal(m.dispersion.y)));
    if (m.opacity != usual.opacity) key(w, "opacity", toml_color(m.opacity));
    if (m.environment != usual.environment) key(w, "environment", decimal(m.environment));
}

} // namespace

void write_material(TomlWriter& w, std::size_t index) {
    const Material& m = w.scene.materials[index];
    const Material usual;
    const std::string where = fmt::format("material \"{}\"", w.materials[index]);
    begin_section(w, "[[material]]");
    key(w, "name", quoted_toml(w.materials[index]));
    if (m.diffuse != usual.diffuse) key(w, "diffuse", toml_color(m.diffuse));
    write_highlight(w, m, usual);
    write_rays(w, m, usual);
    if (m.emission != usual.emission) key(w, "emission", toml_color(m.emission));
    if (m.two_sided) key(w, "two_sided", *m.two_sided ? "true" : "false");
    if (m.texture) key(w, "texture", texture_text(w, *m.texture, where));
    if (m.bump) key(w, "bump", bump_text(w, *m.bump, where));
}

} // namespace lightbench
