// Lines over a picture: the edges of the tessellation, the normals of its vertices, rays. In: a shot, a scene. Out: the shot with a marked copy.
#pragma once

#include "app/view/stage.h"

namespace lightbench::view {

// Edges of what faces the eye, those hidden behind others included; one normal of each vertex, of some where there are very many.
void mark(Shot& shot, const Scene& scene, bool wireframe, bool normals);

// Where a point of the world is in the picture, in pixels; nothing if it lies behind the eye.
std::optional<glm::dvec2> pixel_of(const View& view, const glm::dvec3& world);

} // namespace lightbench::view
