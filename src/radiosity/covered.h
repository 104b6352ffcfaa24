// Which elements lie on another surface, where no light gets to. In: faces, elements and the faces they are of. Out: marks. Pure.
#pragma once

#include "radiosity/base_faces.h"
#include "radiosity/patches.h"

namespace lightbench {

// Marks elements whose center lies on another face that looks the opposite way, front on front, if one of the two bounds a closed opaque
// solid: a box on a floor. (Sheets back to back are seen from both sides.) A solid whose bottom is left out counts as if it had it: faces
// that hang together over their edges, whose open edges all lie in one plane, that lie on one side of it, look outwards, are opaque and
// dark, and have no lamp between them.
void mark_covered(const Scene& scene, const BaseMesh& base, const BaseEdges& edges, const std::vector<std::uint32_t>& face_of_element,
                  PatchMesh& mesh);

} // namespace lightbench
