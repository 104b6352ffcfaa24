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
    vec3 center; float area;       // frame; off the surface by what rays that start there may be wrong by
    vec3 normal; uint patch_number;
    vec3 reflectance; uint covered; // rho
};

// A patch as it sends: one a PatchMesh::patches.
struct Shooter {
    vec3 center; float area;       // as Receiver
    vec3 normal; float radius;
    vec3 tangent; uint first;      // unit, perpendicular to the normal, turned about it by the patch's own angle; its first element
    vec3 reflectance; uint count;  // mean; elements
};

// Where a hemi-cube stands: of each patch that was chosen.
struct HemicubeView {
    vec3 center; uint patch_number; // kNoElement: none
    vec3 tangent; uint first;       // the patch's own elements, which it does not see
    vec3 bitangent; uint count;
    vec3 normal; float radius;
    float area;
    uint pad0, pad1, pad2;
};
const uint kHemicubeViewTexels = 5u;

// Specialisation constants of hemi-cubes, besides those of the ray tracer; tables that may be storage buffers.
#define CONSTANT_RESOLUTION 24        // pixels along a face's edge
#define CONSTANT_NEAR_RAYS 25         // from an element to a patch that is near
#define FETCH_SHOOTERS 0x20000u
#define FETCH_RECEIVERS 0x40000u
#define FETCH_HEMICUBE_VIEWS 0x80000u
#define FETCH_HEMICUBE_ITEMS 0x100000u
#define FETCH_HEMICUBE_DELTAS 0x200000u
#define FETCH_ELEMENT_CORNERS 0x400000u
#define FETCH_UNSHOT 0x800000u
#define CONSTANT_SHARES 26            // 1: what each element has to shoot is told, as a table of SolveState (solve.h)

// Analytic form factors replace those of the hemi-cube where an element lies nearer than this many sizes of the patch (twice its radius).
// There a square's centre stands for all of it with an error of 1.3 % (HC-3); at two sizes it is 7 %.
const float kNearSizes = 5.0;
const uint kElementCornerTexels = 4u; // a triangle's last two are equal

struct HemicubePush {
    uint count;    // invocations of a layer
    uint elements; // of the mesh
    uint cube, face; // of a drawing: which hemi-cube of the batch, which of its five faces
    float near_sizes; // elements nearer than so many sizes of a patch get analytic form factors
};

// A hemi-cube's items: uint each, top n * n, then the sides +tangent, -tangent, +bitangent, -bitangent, n / 2 rows of n each from the horizon
// up; 3 n n in all. Columns of the top go along the tangent, its rows along the bitangent = cross(normal, tangent); columns of the sides
// +-tangent along the bitangent, of the sides +-bitangent along the tangent; always from negative to positive.

#ifdef __cplusplus
static_assert(sizeof(Receiver) == 16 * kReceiverTexels && sizeof(Shooter) == 16 * kShooterTexels &&
              sizeof(HemicubeView) == 16 * kHemicubeViewTexels && sizeof(HemicubePush) == 20);
} // namespace lightbench::gpu_layout
#endif

#endif
