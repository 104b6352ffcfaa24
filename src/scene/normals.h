// Face normals and vertex normals, in double. In: faces. Out: a normal a face; a normal a corner, smooth up to the crease angle.
#pragma once

#include "scene/tessellate_faces.h"

namespace lightbench {

// The unit normal of a face (Newell's sum), or 0 if it has no area: none beyond what rounding makes of it (NI-3).
glm::dvec3 face_normal(const std::vector<glm::dvec3>& points, std::span<const Corner> loop);

std::vector<glm::dvec3> face_normals(const Faces& faces);

// The inner angle of a face at a corner, reflex ones too: radians, in [0, 2 pi).
double corner_angle(const glm::dvec3& to_next, const glm::dvec3& to_previous, const glm::dvec3& normal);

// Gives every corner without a normal the mean of the face normals around its point, weighted by the faces' angles there. Only faces that
// hang together across edges of less than `crease` radians are averaged: each such group has a normal of its own.
void smooth_normals(Faces& faces, const std::vector<glm::dvec3>& of_faces, double crease);

// Normals nearer than this to the plane of a face, or behind it, are not interpolated over it. The interpolated normal of a face has at
// least this length, so making it unit multiplies the rounding of float32 (1.4e-7) by 20 at most, to 3e-6 radians: 1/80 of an 8-bit step.
constexpr double kMinFacing = 0.05;

// Corners whose normals face less take their face's own, so that no interpolated normal vanishes (NI-1). Leaves corners in `kept` alone.
void face_outwards(Faces& faces, const std::vector<glm::dvec3>& of_faces, const std::vector<bool>& kept = {});

// Do the normals of each face's corners all face the same side of it, by kMinFacing at least? Then no mean of them vanishes.
bool all_on_one_side(const Faces& faces, const std::vector<glm::dvec3>& of_faces);

} // namespace lightbench
