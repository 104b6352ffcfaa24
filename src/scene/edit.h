// Changes of a scene: what loaders and makers add, and a scene as somebody wants to see it, not as its file has it: without some effects.
// In: a scene, what to add or leave out. Out: the same scene changed, and where or how much. Leaving out twice changes no more than once.
#pragma once

#include "scene/scene.h"

#include <array>
#include <string_view>

namespace lightbench {

// Index of the new material.
std::uint32_t add_material(Scene& scene, Material material);

// What can be left out; bit i of SceneEdits::without is kStrippable[i].
constexpr std::array<std::string_view, 5> kStrippable = {"texture", "bump", "environment", "transparency", "reflection"};
constexpr std::uint32_t kWithoutTexture = 1, kWithoutBump = 2, kWithoutEnvironment = 4, kWithoutTransparency = 8, kWithoutReflection = 16;

struct SceneEdits {
    std::uint32_t without = 0;
    bool operator==(const SceneEdits&) const = default;
};

// Materials (and for the environment, the map) lose what `effects` names; returns how many materials changed.
std::size_t keep_without(Scene& scene, std::uint32_t effects);

} // namespace lightbench
