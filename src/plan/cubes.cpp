#include "plan/cubes.h"

#include "plan/complete.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lightbench {
namespace {

bool mirrors(const Scene& scene, const Object& object) {
    const auto weighs = [&](std::uint32_t material) { return scene.materials[material].environment > 0; };
    const auto* use = std::get_if<MeshUse>(&object.shape);
    if (use == nullptr || scene.meshes[use->mesh].face_materials.empty()) return weighs(object.material);
    return std::ranges::any_of(scene.meshes[use->mesh].face_materials, weighs);
}

// The power of two at or above the pixels that the object's largest extent spans. A mirroring ball shows nearly all that surrounds it,
// twice as wide as a face in the middle, ever narrower towards its edge.
unsigned size_of(const Bounds& bounds, const glm::dvec3& center, const View& view) {
    const glm::dvec3 half = 0.5 * (bounds.max - bounds.min);
    const double radius = std::max({half.x, half.y, half.z}), distance = glm::length(center - view.eye);
    if (distance <= radius) return kLargestCubeSize;
    const double pixels = 2 * std::asin(radius / distance) / view.pixel_angle();
    const double held = std::clamp<double>(std::ceil(pixels), kLeastCubeSize, kLargestCubeSize);
    return std::bit_ceil(static_cast<unsigned>(held));
}

// The largest are halved until all fit: 4 of 512 pixels are 64 MiB with their smaller levels, half of what a storage buffer always has.
void bound_sizes(std::vector<EnvironmentCube>& cubes) {
    const auto pixels = [&] {
        std::size_t sum = 0;
        for (const EnvironmentCube& cube : cubes) sum += std::size_t{cube.size} * cube.size;
        return sum;
    };
    for (unsigned most = kLargestCubeSize; pixels() > 4ul * kLargestCubeSize * kLargestCubeSize; most /= 2)
        for (EnvironmentCube& cube : cubes) cube.size = std::min(cube.size, most / 2);
}

double squared(const glm::dvec3& v) {
    return glm::dot(v, v);
}

// One of the objects that mirror; `cube` is the one that it would have for itself.
struct Mirror {
    double distance = 0; // metres squared, to the camera
    EnvironmentCube cube;
};

std::vector<Mirror> mirrors_of(const Scene& scene, const View& view) {
    std::vector<Mirror> found;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (!mirrors(scene, scene.objects[i])) continue;
        const Bounds bounds = bounds_of(scene, scene.objects[i]);
        if (bounds.empty()) continue;
        const glm::dvec3 center = 0.5 * bounds.min + 0.5 * bounds.max;
        found.push_back({squared(center - view.eye), {static_cast<std::uint32_t>(i), center, size_of(bounds, center, view)}});
    }
    return found;
}

std::uint32_t nearest(const std::vector<EnvironmentCube>& cubes, const glm::dvec3& center) {
    const auto at = std::ranges::min_element(cubes, {}, [&](const EnvironmentCube& cube) { return squared(cube.center - center); });
    return static_cast<std::uint32_t>(at - cubes.begin());
}

} // namespace

EnvironmentCubes choose_cubes(const Scene& scene, const View& view) {
    EnvironmentCubes chosen;
    std::vector<Mirror> found = mirrors_of(scene, view);
    chosen.objects = found.size();
    if (found.empty()) return chosen;
    std::ranges::stable_sort(found, {}, &Mirror::distance);
    const std::size_t count = std::min(found.size(), kMostCubes);
    for (std::size_t i = 0; i < count; ++i) chosen.cubes.push_back(found[i].cube);
    bound_sizes(chosen.cubes);
    chosen.of_object.resize(scene.objects.size(), 0);
    for (std::size_t i = 0; i < found.size(); ++i)
        chosen.of_object[found[i].cube.object] = i < count ? static_cast<std::uint32_t>(i) : nearest(chosen.cubes, found[i].cube.center);
    return chosen;
}

} // namespace lightbench
