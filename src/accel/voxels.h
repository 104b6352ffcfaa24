// What grid and octree share: which primitives a voxel holds, and how references are stored. In: RayPrimitives. Out: overlap tests, texels.
#pragma once

#include "accel/accel.h"

namespace lightbench {

// A voxel, in double: closed, so that a face that lies on its plane belongs to both sides (TS-7).
struct Voxel {
    glm::dvec3 min{0}, max{0};
};

// Primitives by number, with boxes that are larger than boxes_of() by the error of a walk: a walk that is in a voxel's neighbour by mistake
// still meets what it needs (TS-4, TS-5).
class VoxelItems {
  public:
    explicit VoxelItems(const RayPrimitives& primitives);
    std::size_t size() const { return boxes_.size(); }
    const Voxel& box(std::size_t number) const { return boxes_[number]; }
    const Voxel& all() const { return all_; } // a box about all boxes; 0 if there are none

    // May the primitive reach into the voxel? No only if it surely does not.
    bool overlaps(std::size_t number, const Voxel& voxel) const;
    std::uint32_t reference(std::size_t number) const;

  private:
    const RayPrimitives& primitives_; // in the order of the numbers
    std::vector<Voxel> boxes_;
    Voxel all_;
    double error_; // of rays: boxes_ have twice that as padding
};

// References of lists that follow each other, four a texel; the last texel is filled with kNothing.
void append_words(std::vector<gpu_layout::uvec4>& texels, const std::vector<std::uint32_t>& words);

void build_grid(AccelTables& tables, const RayPrimitives& primitives, const AccelRequest& request);
void build_octree(AccelTables& tables, const RayPrimitives& primitives, const AccelRequest& request);

} // namespace lightbench
