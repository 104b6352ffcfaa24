#include "scene/edit.h"

namespace lightbench {
namespace {

void strip(Material& m, std::uint32_t effects) {
    if (effects & kWithoutTexture) m.texture.reset();
    if (effects & kWithoutBump) m.bump.reset();
    if (effects & kWithoutEnvironment) m.environment = 0;
    if (effects & kWithoutTransparency) {
        m.opacity = glm::vec3(1), m.transmission = glm::vec3(0);
        if (m.texture) m.texture->alpha = false;
    }
    if (effects & kWithoutReflection) m.reflection = glm::vec3(0);
}

} // namespace

std::uint32_t add_material(Scene& scene, Material material) {
    scene.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

std::size_t keep_without(Scene& scene, std::uint32_t effects) {
    std::size_t changed = 0;
    for (Material& material : scene.materials) {
        Material stripped = material;
        strip(stripped, effects);
        if (stripped == material) continue;
        material = std::move(stripped), ++changed;
    }
    if (effects & kWithoutEnvironment) scene.environment.map.clear();
    return changed;
}

} // namespace lightbench
