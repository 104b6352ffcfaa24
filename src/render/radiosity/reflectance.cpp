#include "render/radiosity/reflectance.h"

#include "image/display.h"
#include "plan/facts.h"
#include "render/materials.h"

#include <glm/gtc/constants.hpp>
#include <map>

namespace lightbench {
namespace {

// Linear light, over all pixels.
glm::vec3 mean_of(const AnyImage& picture) {
    glm::dvec3 sum(0);
    std::size_t pixels = 0;
    if (const auto* linear = std::get_if<ImageF>(&picture)) {
        pixels = linear->rgba.size() / 4;
        for (std::size_t i = 0; i < pixels; ++i) sum += glm::dvec3(linear->rgba[4 * i], linear->rgba[4 * i + 1], linear->rgba[4 * i + 2]);
    } else {
        const auto& encoded = std::get<Image8>(picture);
        pixels = encoded.rgba.size() / 4;
        for (std::size_t i = 0; i < pixels; ++i)
            for (int c = 0; c < 3; ++c) sum[c] += linear_from_srgb(encoded.rgba[4 * i + static_cast<std::size_t>(c)] / 255.0f);
    }
    return glm::vec3(sum / double(std::max<std::size_t>(pixels, 1)));
}

// Half of a checker's squares are as bright as its material.
glm::vec3 mean_of_texture(const Scene& scene, const Texture& texture) {
    constexpr float kDark = 0.2f; // as shaders/texture.glsl has it
    if (!texture.picture) return glm::vec3((1 + kDark) / 2);
    return mean_of(decode_picture(scene.pictures[*texture.picture]));
}

glm::vec3 reflectance_of(const Scene& scene, const Material& material) {
    const glm::vec3 rho = material.texture ? material.diffuse * mean_of_texture(scene, *material.texture) : material.diffuse;
    return glm::clamp(rho, 0.0f, kMostReflectance);
}

} // namespace

SurfaceLight surface_light(const Scene& scene, const PatchMesh& mesh) {
    std::map<std::uint32_t, glm::vec3> known; // by material
    SurfaceLight light;
    for (const Element& e : mesh.elements) {
        const std::uint32_t material = mesh.surfaces[e.surface].material;
        const auto [it, made] = known.try_emplace(material);
        if (made) it->second = reflectance_of(scene, scene.materials[material]);
        light.reflectance.push_back(it->second);
        light.emission.push_back(glm::pi<float>() * scene.materials[material].emission);
    }
    return light;
}

} // namespace lightbench
