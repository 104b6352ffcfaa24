// What the passes of radiosity share with the host. Scalar block layout; structs are whole texels of RGBA32UI.
#ifndef LIGHTBENCH_SHARED_RADIOSITY_H
#define LIGHTBENCH_SHARED_RADIOSITY_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace lightbench::gpu_layout {
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;
#endif

const uint kHemicubeOne = 1u << 31u;     // a form factor of 1: sums of integers come out the same in whatever order they are added
const uint kNoElement = 0xffffffffu;    // an item of a hemi-cube that sees nothing; a shooter that does not shoot
const uint kReceiverTexels = 3u, kShooterTexels = 4u;

// An element as it receives: one a PatchMesh::elements.
struct Receiver {
    vec3 center; float area;       // frame
    vec3 normal; uint patch_number;
    vec3 reflectance; uint covered; // rho
};

// A patch as it sends: one a PatchMesh::patches.
struct Shooter {
    vec3 center; float area;
    vec3 normal; float radius;
    vec3 tangent; uint first;      // unit, perpendicular to the normal, turned about it by the patch's own angle; its first element
    vec3 reflectance; uint count;  // mean; elements
};

// A hemi-cube's items: uint each, top n * n, then the sides +tangent, -tangent, +bitangent, -bitangent, n / 2 rows of n each from the horizon
// up; 3 n n in all. Columns of the top go along the tangent, its rows along the bitangent = cross(normal, tangent); columns of the sides
// +-tangent along the bitangent, of the sides +-bitangent along the tangent; always from negative to positive.

#ifdef __cplusplus
static_assert(sizeof(Receiver) == 16 * kReceiverTexels && sizeof(Shooter) == 16 * kShooterTexels);
} // namespace lightbench::gpu_layout
#endif

#endif
