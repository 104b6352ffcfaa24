// From faces to triangles and vertices: every face is triangulated, and corners that agree in point, normal, detail and
// material become one vertex.
#pragma once

#include "scene/tessellate_faces.h"

namespace lightbench {

// `of_faces` is a normal a face, never 0. Without `normals` vertices differ in their points alone. `details` may be null, and is used up.
Facets facets_of(const Faces& faces, const std::vector<glm::dvec3>& of_faces, bool normals, Details* details = nullptr);

} // namespace lightbench
