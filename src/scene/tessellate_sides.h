// Which faces are seen from one side only. In: an object. Out: whether both sides of its opaque and of its translucent faces are drawn.
#pragma once

#include "scene/scene.h"
#include "scene/tessellate_mesh.h"

namespace lightbench {

// Of an object's opaque faces. `welded` is the object's mesh, null for other shapes.
bool is_two_sided(const Scene& scene, const Object& object, const WeldedMesh* welded);

// Of a face of a translucent material: one looks through the front and sees the back, unless the material forbids it.
bool is_two_sided(const Material& translucent);

} // namespace lightbench
