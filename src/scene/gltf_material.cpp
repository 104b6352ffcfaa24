// Reads glTF materials from the JSON: Assimp drops some of their extensions, and their order.
#include "scene/gltf_material.h"

#include "scene/import_text.h"

#include <algorithm>
#include <cmath>

namespace lightbench::importer {

namespace {

struct Context {
    ImportJob& job;
    const GltfDocument& document;
    GltfMaterials& known;
};

// What both workflows of glTF come down to.
struct Surface {
    glm::vec4 base{1};
    glm::vec3 f0{0.04f};
    float metallic = 0, roughness = 1;
    GltfValue texture;
};

Picture embedded(const Context& in, const GltfValue& image, const std::string& uri) {
    Picture picture;
    const std::string name = image.text("name");
    picture.file = name.empty() ? image.place : clean_name(name);
    if (!uri.empty()) {
        const std::string bytes = data_uri(uri, in.job.report, image.place).value_or("");
        picture.encoded.assign(bytes.begin(), bytes.end());
    } else if (const auto view = image.index("bufferView", in.document.root().array("bufferViews").size())) {
        const auto bytes = view_of(in.document, *view);
        picture.encoded.assign(bytes.begin(), bytes.end());
    } else
        image.problem("has neither a uri nor a bufferView");
    return picture;
}

std::optional<std::uint32_t> picture_of(Context& in, std::size_t index) {
    const auto found = in.known.pictures.find(index);
    if (found != in.known.pictures.end()) return found->second;
    const GltfValue image = in.document.root().array("images").item(index);
    const std::string uri = image.text("uri");
    const bool is_file = !uri.empty() && !uri.starts_with("data:");
    const auto picture =
        is_file ? add_picture_file(in.job, file_uri(uri)) : std::optional(add_picture(in.job.scene, embedded(in, image, uri)));
    return in.known.pictures[index] = picture;
}

// From a textureInfo to the picture behind it.
std::optional<std::uint32_t> picture_of(Context& in, const GltfValue& info) {
    const GltfValue textures = in.document.root().array("textures");
    const auto texture = info.index("index", textures.size());
    const auto source = texture ? textures.item(*texture).index("source", in.document.root().array("images").size()) : std::nullopt;
    return source ? picture_of(in, *source) : std::nullopt;
}

// Section 5.26: the numbers are OpenGL's.
Wrap wrap_of(const GltfValue& sampler, const char* key) {
    switch (const std::uint64_t mode = sampler.count(key, 10497); mode) {
    case 10497: return Wrap::repeat;
    case 33071: return Wrap::clamp;
    case 33648: return Wrap::mirror;
    default:
        sampler.problem(fmt::format("{} is {}; it must be 10497 (repeat), 33071 (clamp to edge) or 33648 (mirrored repeat)", key, mode));
        return Wrap::repeat;
    }
}

void set_wraps(Context& in, const GltfValue& info, Texture& texture) {
    const GltfValue textures = in.document.root().array("textures"), samplers = in.document.root().array("samplers");
    const auto index = info.index("index", textures.size());
    const auto sampler = index ? textures.item(*index).index("sampler", samplers.size()) : std::nullopt;
    if (!sampler) return;
    texture.wrap_u = wrap_of(samplers.item(*sampler), "wrapS");
    texture.wrap_v = wrap_of(samplers.item(*sampler), "wrapT");
}

void set_texture(Context& in, const GltfValue& info, Material& material, GltfMaterial& result) {
    if (!info) return;
    const GltfValue transform = info.extension("KHR_texture_transform");
    result.uv_set = transform.has("texCoord") ? transform.count("texCoord", 0) : info.count("texCoord", 0);
    if (transform.has("offset") || transform.has("rotation")) in.job.report.remark("offset and rotation of textures are not used");
    const glm::dvec2 scale = transform.numbers("scale", glm::dvec2(1));
    const auto picture = picture_of(in, info);
    if (!picture) return;
    material.texture = Texture{picture, Mapping::uv, scale};
    set_wraps(in, info, *material.texture);
}

void set_normal_map(Context& in, const GltfValue& info, Material& material) {
    if (!info) return;
    Bump bump;
    bump.picture = picture_of(in, info), bump.normal_map = true;
    bump.amplitude = info.number("scale", 1);
    if (bump.picture) material.bump = bump;
}

Surface metallic_roughness(const GltfValue& value, float ior) {
    const GltfValue pbr = value.object("pbrMetallicRoughness");
    Surface s;
    s.base = glm::clamp(pbr.numbers("baseColorFactor", glm::vec4(1)), 0.0f, 1.0f);
    s.metallic = static_cast<float>(std::clamp(pbr.number("metallicFactor", 1), 0.0, 1.0));
    s.roughness = static_cast<float>(std::clamp(pbr.number("roughnessFactor", 1), 0.0, 1.0));
    const float dielectric = (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1));
    s.f0 = glm::mix(glm::vec3(dielectric), glm::vec3(s.base), s.metallic);
    s.texture = pbr.object("baseColorTexture");
    return s;
}

Surface specular_glossiness(const GltfValue& value) {
    Surface s;
    s.base = glm::clamp(value.numbers("diffuseFactor", glm::vec4(1)), 0.0f, 1.0f);
    s.f0 = glm::clamp(value.numbers("specularFactor", glm::vec3(1)), 0.0f, 1.0f);
    s.roughness = static_cast<float>(1 - std::clamp(value.number("glossinessFactor", 1), 0.0, 1.0));
    s.texture = value.object("diffuseTexture");
    return s;
}

// What becomes of metallic-roughness, whose work that is and what it loses: gltf_material.h.
void set_reflectance(Material& m, const Surface& s, float transmission) {
    constexpr float kLeastSlope = 1e-3f; // a lobe of 0.1 degrees, far below a pixel; the exponent stays at 2e6
    constexpr float kMostF0 = 0.9999f;   // f0 = 1 has no finite index of refraction
    const float slope = std::max(s.roughness * s.roughness, kLeastSlope);
    const glm::vec3 base(s.base);
    m.model = Model::cook_torrance;
    m.distribution = Distribution::beckmann;
    m.roughness = slope, m.scatter = transmission > 0 || s.metallic > 0 ? slope : 0;
    m.f0 = glm::min(s.f0, kMostF0), m.reflection = s.f0;
    m.diffuse = base * ((1 - s.metallic) * (1 - transmission));
    m.transmission = base * ((1 - s.metallic) * transmission);
    m.fresnel = transmission > 0;
    m.shininess = std::max(2 / (slope * slope) - 2, 0.0f);
    m.specular = glm::vec3(1); // the color is in f0
}

void remark_unused(ImportJob& job, const GltfValue& value) {
    const GltfValue pbr = value.object("pbrMetallicRoughness");
    if (pbr.has("metallicRoughnessTexture") || value.has("occlusionTexture") || value.has("emissiveTexture"))
        job.report.remark("textures of metallic, roughness, occlusion and emission are not used");
    if (value.text("alphaMode") == "MASK") job.report.remark("alphaMode MASK is drawn opaque");
}

GltfMaterial read_material(Context& in, const GltfValue& value) {
    Material m;
    m.name = clean_name(value.text("name"));
    const auto ior = static_cast<float>(value.extension("KHR_materials_ior").number("ior", 1.5));
    if (ior >= 1) m.ior = glm::vec3(ior); // 0 stands for "reflects all" in the extension
    const GltfValue glossy = value.extension("KHR_materials_pbrSpecularGlossiness");
    const Surface surface = glossy ? specular_glossiness(glossy) : metallic_roughness(value, m.ior.x);
    const double transmission = value.extension("KHR_materials_transmission").number("transmissionFactor", 0);
    set_reflectance(m, surface, static_cast<float>(std::clamp(transmission, 0.0, 1.0)));
    const double strength = value.extension("KHR_materials_emissive_strength").number("emissiveStrength", 1);
    m.emission = glm::max(value.numbers("emissiveFactor", glm::vec3(0)) * static_cast<float>(strength), 0.0f);
    if (value.text("alphaMode") == "BLEND") m.opacity = glm::vec3(surface.base.w);
    m.two_sided = value.flag("doubleSided", false);
    GltfMaterial result;
    set_texture(in, surface.texture, m, result);
    if (m.texture && value.text("alphaMode") == "BLEND") m.texture->alpha = true; // section 3.9.4: alpha is that of factor times texture
    set_normal_map(in, value.object("normalTexture"), m);
    remark_unused(in.job, value);
    result.material = add_material(in.job.scene, m);
    return result;
}

} // namespace

GltfMaterial material_for(ImportJob& job, const GltfDocument& document, std::optional<std::size_t> index, GltfMaterials& known) {
    if (!index) {
        if (!known.plain) known.plain = GltfMaterial{add_material(job.scene, Material{}), 0};
        return *known.plain;
    }
    const auto found = known.added.find(*index);
    if (found != known.added.end()) return found->second;
    Context in{job, document, known};
    return known.added[*index] = read_material(in, document.root().array("materials").item(*index));
}

} // namespace lightbench::importer
