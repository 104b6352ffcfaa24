// The tree of boxes built on the device, for scenes that change: a linear BVH. Lauterbach, Garland, Sengupta, Luebke, Manocha 2009, "Fast BVH
// Construction on GPUs" (the curve); Karras 2012 (the hierarchy). In: primitives. Out: the tables that accel/bvh.cpp would make, of another
// tree; the same bytes every time.
#pragma once

#include "accel/accel.h"
#include "render/device_sort.h"

#include <memory>

namespace lightbench {

struct DeviceTree {
    gpu::Buffer nodes, narrow;              // as walks read them
    gpu::Buffer triangles, spheres, shapes; // in the order of its leaves; none where there are none
    AccelTables accel;                      // without its tables
    gpu::Timings times;                     // of the passes
};

// Pipelines and buffers, kept from one build to the next.
class DeviceBuilder {
  public:
    explicit DeviceBuilder(gpu::Device& device);
    DeviceBuilder(DeviceBuilder&&) noexcept;
    ~DeviceBuilder();

    // At least two primitives outside of those that stay out of every tree (accel/accel.h: loose_types). leaf 1 to 4, 0: 4.
    // EnvironmentError if a table would be larger than a shader reaches.
    DeviceTree build(const RayPrimitives& primitives, std::uint32_t leaf);

    // Builds a small tree of the same types: drivers compile at the first dispatch, which is not the time that building takes.
    void warm_up(const RayPrimitives& primitives);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// Enough of them for a tree?
bool has_tree(const RayPrimitives& primitives);

} // namespace lightbench
