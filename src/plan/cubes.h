// Which objects see the scene around them (S12, without a map): those nearest to the camera, each with a cube of six views from its centre;
// the others that mirror share the cube whose centre is nearest. In: a completed scene, its view. Out: cubes, and who shows which. Pure.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace lightbench {

struct View;

struct EnvironmentCube {
    std::uint32_t object = 0; // index into Scene::objects: left out of its own views
    glm::dvec3 center{0};     // world, of the object's bounds
    unsigned size = 0;        // pixels, the side of a face
};

struct EnvironmentCubes {
    std::size_t objects = 0;              // that mirror the scene
    std::vector<EnvironmentCube> cubes;   // the nearest first
    std::vector<std::uint32_t> of_object; // by object, index into cubes, 0 where nothing is mirrored; empty if there is no cube
};

constexpr std::size_t kMostCubes = 8;
constexpr unsigned kLeastCubeSize = 32, kLargestCubeSize = 512;

EnvironmentCubes choose_cubes(const Scene& scene, const View& view);

} // namespace lightbench
