// Converts materials to the shared layout; decodes pictures once each, however many surfaces show them.
#include "render/materials.h"

#include "image/files.h"
#include "scene/distribution.h"
#include "scene/surfaces.h"
#include "shared/effects.h"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <tuple>

namespace lightbench {
namespace {

// A number that is not finite would spread from level to level, and over all that is filtered.
void check_finite(const AnyImage& image, const std::string& name) {
    const auto* floats = std::get_if<ImageF>(&image);
    if (floats == nullptr) return;
    const auto found = std::ranges::find_if(floats->rgba, [](float x) { return !std::isfinite(x); });
    if (found == floats->rgba.end()) return;
    const auto pixel = static_cast<std::size_t>(found - floats->rgba.begin()) / 4;
    throw FileError(FileError::Blame::Input, fmt::format("{}: pixel {}, {} is not finite; a picture of a scene must be", name,
                                                         pixel % floats->width, pixel / floats->width));
}

std::uint32_t model_kind(const Material& m) {
    if (m.model == Model::phong) return gpu_layout::kModelPhong;
    return m.distribution == Distribution::gaussian ? gpu_layout::kModelGaussian : gpu_layout::kModelBeckmann;
}

std::uint32_t texture_kind(const Material& m) {
    if (!m.texture) return gpu_layout::kTextureNone;
    if (!m.texture->picture) return gpu_layout::kTextureChecker;
    return m.texture->alpha ? gpu_layout::kTextureWithAlpha : gpu_layout::kTexturePicture;
}

std::uint32_t bump_kind(const Material& m) {
    if (!m.bump) return gpu_layout::kBumpNone;
    if (m.bump->picture) return m.bump->normal_map ? gpu_layout::kBumpNormalMap : gpu_layout::kBumpHeight;
    return m.bump->function == BumpFunction::waves ? gpu_layout::kBumpWaves : gpu_layout::kBumpNoise;
}

// What a picture's values stand for.
enum class Content { color, data, heights };

class Converter {
  public:
    Converter(const Scene& scene, const Frame& frame, const Plan& plan) : scene_(scene), frame_(frame), plan_(plan) {}
    gpu_layout::Material convert(const Surface& surface);
    gpu_layout::TexelInfo picture(std::uint32_t index, Content content, Wrap u, Wrap v);
    gpu_layout::TexelInfo faces(std::span<const AnyImage> images) { return texels_.add_faces(images); }
    void add_cubes(std::span<const CubeFaces> cubes);
    TexelTable take() { return std::move(texels_); }

  private:
    void set_model(const Material& m, gpu_layout::Material& out) const;
    void set_rays(const Material& m, gpu_layout::Material& out) const;
    void set_pictures(const Material& m, gpu_layout::Material& out);
    void set_mapping(const Material& m, const Object& object, gpu_layout::Material& out) const;
    bool draws(std::uint32_t effects) const { return plan_.effects & effects; }

    const Scene& scene_;
    const Frame& frame_;
    const Plan& plan_;
    TexelTable texels_;
    std::vector<gpu_layout::TexelInfo> cubes_; // as Plan::cubes
    std::map<std::tuple<std::uint32_t, Content, Wrap, Wrap>, gpu_layout::TexelInfo> known_;
};

gpu_layout::TexelInfo Converter::picture(std::uint32_t index, Content content, Wrap u, Wrap v) {
    const auto [it, made] = known_.try_emplace({index, content, u, v});
    if (!made) return it->second;
    const AnyImage image = decode_picture(scene_.pictures[index]);
    const auto wrap_u = static_cast<std::uint32_t>(u), wrap_v = static_cast<std::uint32_t>(v);
    it->second = content == Content::heights ? texels_.add_heights(image, wrap_u, wrap_v)
                                             : texels_.add(image, content == Content::color, wrap_u, wrap_v);
    return it->second;
}

void Converter::add_cubes(std::span<const CubeFaces> cubes) {
    for (const CubeFaces& cube : cubes) cubes_.push_back(faces(std::vector<AnyImage>(cube.begin(), cube.end())));
}

void Converter::set_model(const Material& m, gpu_layout::Material& out) const {
    out.kinds = model_kind(m) | texture_kind(m) << 4 | bump_kind(m) << 12;
    out.ior = glm::clamp(m.f0 ? ior_of_f0(*m.f0) : m.ior, 1e-9f, 1e9f); // what lib/fresnel.glsl takes
    out.roughness = std::max(m.roughness, static_cast<float>(kLeastRoughness));
    if (draws(EFFECT_COOK_TORRANCE)) out.lobe = static_cast<float>(lobe_factor(m.distribution, out.roughness));
}

// Cauchy's A + B / lambda^2, lambda in micrometres (SPEC S18, RULINGS).
glm::vec3 refraction_of(const Material& m) {
    if (m.dispersion.y == 0) return m.ior;
    const glm::vec3 wavelength(0.65f, 0.55f, 0.45f);
    return m.dispersion.x + m.dispersion.y / (wavelength * wavelength);
}

void Converter::set_rays(const Material& m, gpu_layout::Material& out) const {
    out.reflection = m.reflection.value_or(m.specular);
    // What no reflected ray is sent after mirrors the environment; the rest meets it where its rays leave the scene.
    if (glm::any(glm::greaterThan(out.reflection, glm::vec3(0)))) out.mirror = glm::vec3(0);
    out.scatter = m.scatter, out.transmission = m.transmission;
    out.refraction = refraction_of(m);
    const bool disperses = out.refraction.x != out.refraction.y || out.refraction.x != out.refraction.z;
    out.splits = (m.fresnel ? gpu_layout::kSplitFresnel : 0) | (disperses ? gpu_layout::kSplitDispersion : 0) |
                 (hides_backs(m) ? gpu_layout::kOneSided : 0);
}

void Converter::set_pictures(const Material& m, gpu_layout::Material& out) {
    out.repeats = glm::vec2(m.texture ? m.texture->scale : glm::dvec2(1));
    const Wrap u = m.texture ? m.texture->wrap_u : Wrap::repeat, v = m.texture ? m.texture->wrap_v : Wrap::repeat;
    if (m.texture && m.texture->picture && draws(EFFECT_TEXTURE)) out.texture = picture(*m.texture->picture, Content::color, u, v);
    const Content content = m.bump && m.bump->normal_map ? Content::data : Content::heights;
    if (m.bump && m.bump->picture && draws(EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP)) out.bump = picture(*m.bump->picture, content, u, v);
}

// An object that is scaled keeps the slopes of its bumps: amplitudes are metres of the object, like frequencies.
void Converter::set_mapping(const Material& m, const Object& object, gpu_layout::Material& out) const {
    const Mapping mapping = mapping_of(scene_, object, m);
    out.kinds |= static_cast<std::uint32_t>(mapping) << 8;
    const glm::dmat4& world_from_object = scene_.transforms[object.transform];
    const glm::dmat3 linear(world_from_object);
    const double volume = std::fabs(glm::determinant(linear));
    if (m.bump) {
        const double scale = std::cbrt(volume) * frame_.scale;
        out.amplitude = static_cast<float>(m.bump->normal_map ? m.bump->amplitude : m.bump->amplitude * scale);
        out.bump_scale = glm::vec3(m.bump->frequency * metres_per_mapping_unit(scene_, object, mapping));
    }
    if (volume == 0) return; // flattened to nothing: mapped to the middle
    glm::dmat4 world_from_frame(1 / frame_.scale);
    world_from_frame[3] = glm::dvec4(frame_.origin, 1);
    const glm::dmat4 rows =
        glm::transpose(mapping_from_object(scene_, object, mapping) * glm::inverse(world_from_object) * world_from_frame);
    out.map_x = glm::vec4(rows[0]), out.map_y = glm::vec4(rows[1]), out.map_z = glm::vec4(rows[2]);
}

gpu_layout::Material Converter::convert(const Surface& surface) {
    const Material& m = scene_.materials[surface.material];
    gpu_layout::Material out{};
    out.diffuse = m.diffuse, out.specular = m.specular, out.emission = m.emission, out.shininess = m.shininess;
    const bool traced = plan_.method == Method::raytrace;
    out.opacity = traced ? m.opacity : straight_opacity(m); // where rays are traced, what is transmitted is refracted
    out.mirror = m.environment * m.reflection.value_or(glm::vec3(1));
    if (m.model == Model::cook_torrance) out.mirror = glm::vec3(m.environment); // tinted by its Fresnel term
    if (traced) set_rays(m, out);
    set_model(m, out);
    set_pictures(m, out);
    // A surface that mirrors nothing has one too: what is read there is multiplied by 0, and must be finite.
    if (!cubes_.empty()) out.cube = cubes_[plan_.cubes.of_object[surface.object]];
    if (m.texture || m.bump) set_mapping(m, scene_.objects[surface.object], out);
    return out;
}

// A face is read by its number: all six are square and of one size.
gpu_layout::TexelInfo six_faces(const Scene& scene, Converter& converter) {
    std::vector<AnyImage> faces;
    glm::uvec2 size(0);
    for (const std::uint32_t picture : scene.environment.map) {
        faces.push_back(decode_picture(scene.pictures[picture]));
        const glm::uvec2 own = std::visit([](const auto& image) { return glm::uvec2(image.width, image.height); }, faces.back());
        if (faces.size() == 1) size = own;
        if (own.x != own.y || own != size)
            throw FileError(FileError::Blame::Input,
                            fmt::format("{}: is {} x {}, the first face {} x {}; six faces must be squares of one size",
                                        scene.pictures[picture].file.string(), own.x, own.y, size.x, size.y));
    }
    return converter.faces(faces);
}

gpu_layout::TexelInfo environment_of(const Scene& scene, const Plan& plan, Converter& converter) {
    if (scene.environment.map.empty() || !(plan.effects & (EFFECT_MIRROR_ENVIRONMENT | EFFECT_BACKGROUND_MAP))) return {};
    if (plan.effects & EFFECT_SIX_FACES) return six_faces(scene, converter);
    return converter.picture(scene.environment.map.front(), Content::color, Wrap::repeat, Wrap::clamp);
}

} // namespace

AnyImage decode_picture(const Picture& picture) {
    const std::string name = picture.file.string();
    AnyImage image = picture.encoded.empty() ? read_image(name) : decode_image(picture.encoded, name);
    check_finite(image, name);
    return image;
}

MaterialTables material_tables(const Scene& scene, const RasterGeometry& geometry, const Plan& plan, std::span<const CubeFaces> cubes) {
    MaterialTables tables;
    Converter converter(scene, geometry.frame, plan);
    tables.environment = environment_of(scene, plan, converter);
    converter.add_cubes(cubes);
    const std::span surfaces(geometry.surfaces);
    const std::size_t count = plan.effects & EFFECT_MANY_MATERIALS ? surfaces.size() : std::min<std::size_t>(surfaces.size(), 1);
    for (const Surface& surface : surfaces.first(count)) tables.materials.push_back(converter.convert(surface));
    tables.texels = converter.take();
    return tables;
}

} // namespace lightbench
