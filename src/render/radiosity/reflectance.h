// What the surfaces of a scene send by themselves and send on, as radiosity sees them. In: scene, elements. Out: values an element.
#pragma once

#include "radiosity/patches.h"

namespace lightbench {

struct SurfaceLight {
    std::vector<glm::vec3> emission;    // E = pi * radiance
    std::vector<glm::vec3> reflectance; // rho, at most kMostReflectance; of a picture its mean
};

SurfaceLight surface_light(const Scene& scene, const PatchMesh& mesh);

} // namespace lightbench
