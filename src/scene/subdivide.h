// Refines faces: a triangle into 4, any other convex face into quads about its centre. New points lie on the flat faces and edges.
#pragma once

#include "scene/tessellate_faces.h"

namespace lightbench {

// Splits every face `levels` times and brings `of_faces` (a normal a face) along. Faces that are not convex are cut into triangles first.
// Edges that faces share stay shared, and so do normals: new ones are the means of their neighbours', made unit.
// Texture points are interpolated linearly.
void subdivide(Faces& faces, std::vector<glm::dvec3>& of_faces, unsigned levels);

} // namespace lightbench
