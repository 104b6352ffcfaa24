// A PatchMesh as the passes of hemi-cubes read it. In: PatchMesh. Out: tables, triangles for rays, triangles to draw. Pure.
#pragma once

#include "accel/primitives.h"
#include "radiosity/patches.h"

namespace lightbench {

struct FaceVertex {
    glm::vec3 position; // frame
    glm::uvec2 sides;   // of the triangles whose first vertex this is: the element, the one behind it
};

struct HemicubeMesh {
    std::vector<gpu_layout::Receiver> receivers; // without reflectances: those are the solver's
    std::vector<gpu_layout::Shooter> shooters;
    std::vector<glm::uvec4> corners;    // kElementCornerTexels an element: bits of a float position, 0
    RayPrimitives primitives;           // triangles: `surface` is the element, `object` the one on the other side
    std::vector<FaceVertex> vertices;   // to draw
    std::vector<std::uint32_t> indices; // 3 a triangle, the first is the provoking vertex
};

// Of two elements on the two sides of a surface one is drawn and traced; those that are covered on every side are not.
HemicubeMesh hemicube_mesh(const PatchMesh& mesh);

} // namespace lightbench
