// Which objects are seen from one side only. In: an object. Out: whether both sides are drawn.
#pragma once

#include "scene/scene.h"
#include "scene/tessellate_mesh.h"

namespace lightbench {

// `welded` is the object's mesh, null for other shapes.
bool is_two_sided(const Scene& scene, const Object& object, const WeldedMesh* welded);

} // namespace lightbench
