// What a point is inside of: which of the scene's closed surfaces surround it, the innermost first. For rays that start in a medium (S16).
// In: primitives. Out: surfaces. Pure.
#pragma once

#include "accel/primitives.h"

#include <functional>

namespace lightbench {

// A way out of a surface along a fixed direction.
struct WayOut {
    double distance = 0; // frame units
    std::uint32_t surface = 0;
};

// Of the objects whose surface `counts`, those around `point` (frame), sorted by how far their outsides are along a direction that meets no
// edge of ordinary scenes. Objects of triangles are judged by the parity of crossings, so that open ones may come out either way.
std::vector<WayOut> surfaces_around(const RayPrimitives& primitives, const glm::dvec3& point,
                                    const std::function<bool(std::uint32_t surface)>& counts);

} // namespace lightbench
