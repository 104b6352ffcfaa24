// What rays are tested against: the scene's objects as triangles, spheres and affine images of boxes, balls, cones and tori, in the frame.
// In: Scene, the tessellation of what has no analytic form (meshes, polygons). Out: tables in one fixed order. Pure, no Vulkan.
#pragma once

#include "scene/tessellate.h"
#include "shared/rays.h"

#include <vector>

namespace lightbench {

// Primitive number n is triangles[n], then spheres[n - triangles.size()], then shapes[...].
struct RayPrimitives {
    Frame frame;
    std::vector<gpu_layout::RayTriangle> triangles;
    std::vector<gpu_layout::RaySphere> spheres;
    std::vector<gpu_layout::RayShape> shapes;
    std::vector<gpu_layout::RayCorners> corners; // of each triangle, by number
    std::size_t dropped = 0;                     // shapes without volume or area
    double reach = 4;                            // frame units: no ray starts farther from the frame's origin
    std::size_t size() const { return triangles.size() + spheres.size() + shapes.size(); }
};

struct FloatBox {
    glm::vec3 min{3.4e38f}, max{-3.4e38f};
    bool empty() const { return min.x > max.x; }
    void add(const FloatBox& b) { min = glm::min(min, b.min), max = glm::max(max, b.max); }
    void add(const glm::vec3& p) { min = glm::min(min, p), max = glm::max(max, p); }
    float half_area() const { // of its surface; 0 if empty
        const glm::vec3 d = max - min;
        return empty() ? 0.0f : d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

// `geometry` was tessellated with TessellationRequest::analytic, so that it holds meshes and polygons only. Shapes that are flattened to
// nothing are left out, and counted in `dropped`.
RayPrimitives ray_primitives(const Scene& scene, const RasterGeometry& geometry);

// Boxes of primitives by number; rounded outwards, so that every point of the primitive lies inside.
std::vector<FloatBox> boxes_of(const RayPrimitives& primitives);

// Spheres that hold them likewise: (center, radius).
std::vector<glm::vec4> spheres_of(const RayPrimitives& primitives);

// Frame units by which the test of a primitive, or a walk among planes, may be off: see boxes.cpp.
double error_of_rays(const RayPrimitives& primitives);

} // namespace lightbench
