// Overlap of primitives and voxels, conservative. In: RayPrimitives, a voxel. Out: may they overlap.
#include "accel/voxels.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

using namespace gpu_layout;

bool boxes_touch(const Voxel& a, const Voxel& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

// Distance of the plane from the voxel's center against the voxel's extent along the normal. Akenine-Moller 2001, "Fast 3D Triangle-Box
// Overlap Testing": of its 13 axes the one that boxes do not have. Rounding: 1e-14 of the terms.
bool plane_touches(const RayTriangle& t, const Voxel& voxel, double pad) {
    const glm::dvec3 a(t.v0), n = glm::cross(glm::dvec3(t.v1) - a, glm::dvec3(t.v2) - a);
    const glm::dvec3 center = 0.5 * (voxel.min + voxel.max), half = voxel.max - center + pad, to = center - a;
    const double reach = glm::dot(glm::abs(n), half), slack = 1e-14 * glm::dot(glm::abs(n), glm::abs(center) + glm::abs(a));
    return !(std::abs(glm::dot(n, to)) > reach + slack);
}

// Arvo 1990, "A Simple Method for Box-Sphere Intersection Testing".
bool ball_touches(const RaySphere& s, const Voxel& voxel, double pad) {
    const glm::dvec3 center(s.center), to = glm::clamp(center, voxel.min - pad, voxel.max + pad) - center;
    const double radius = double{s.radius} * (1 + 1e-14);
    return !(glm::dot(to, to) > radius * radius);
}

} // namespace

VoxelItems::VoxelItems(const RayPrimitives& primitives) : primitives_(primitives), error_(error_of_rays(primitives)) {
    FloatBox all;
    for (const FloatBox& box : boxes_of(primitives)) {
        all.add(box);
        boxes_.push_back({glm::dvec3(box.min) - error_, glm::dvec3(box.max) + error_});
    }
    if (!all.empty()) all_ = {glm::dvec3(all.min) - error_, glm::dvec3(all.max) + error_};
}

bool VoxelItems::overlaps(std::size_t number, const Voxel& voxel) const {
    if (!boxes_touch(boxes_[number], voxel)) return false;
    const std::size_t spheres = primitives_.triangles.size();
    if (number < spheres) return plane_touches(primitives_.triangles[number], voxel, 2 * error_);
    if (number - spheres < primitives_.spheres.size()) return ball_touches(primitives_.spheres[number - spheres], voxel, 2 * error_);
    return true;
}

std::uint32_t VoxelItems::reference(std::size_t number) const {
    const std::size_t spheres = primitives_.triangles.size(), shapes = spheres + primitives_.spheres.size();
    const uint type = number < spheres ? kTypeTriangle : number < shapes ? kTypeSphere : kTypeShape;
    const std::size_t first = number < spheres ? 0 : number < shapes ? spheres : shapes;
    return type << kRefType | static_cast<std::uint32_t>(number - first);
}

void append_words(std::vector<uvec4>& texels, const std::vector<std::uint32_t>& words) {
    const std::size_t first = texels.size();
    texels.resize(first + (words.size() + 3) / 4, uvec4(kNothing));
    for (std::size_t i = 0; i < words.size(); ++i) texels[first + i / 4][static_cast<int>(i % 4)] = words[i];
}

} // namespace lightbench
