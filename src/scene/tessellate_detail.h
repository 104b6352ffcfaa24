// Where points lie in the pictures of their surface and how uv changes along it: what textures and bumps of meshes with uv are read with.
#pragma once

#include "scene/tessellate_faces.h"

namespace lightbench {

// The details of faces that have texture points; `of_faces` is a normal a face. With `vertices` also those of corners: one for all corners
// that agree in point, normal, texture point and handedness of uv, so that mirrored halves do not cancel. Their gradients are perpendicular
// to the vertex normal, means of the faces around weighted by the angles there; where the file gives a tangent, u runs along it and v across.
// Faces whose uv has no area have gradients of 0 (BM-2).
Details details_of(const Faces& faces, const std::vector<glm::dvec3>& of_faces, bool vertices);

} // namespace lightbench
