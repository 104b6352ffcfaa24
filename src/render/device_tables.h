// What building on the device goes through: pipelines by what they are specialised for, and buffers that are only read on the way.
#pragma once

#include "render/gpu_scene.h"
#include "shared/build.h"

#include <array>
#include <map>
#include <tuple>

namespace lightbench {

class BuildPipelines {
  public:
    explicit BuildPipelines(gpu::Device& device) : device_(device) {}
    // types: a bit a type of primitive; texels: of a primitive, where they are copied.
    const gpu::ComputePipeline& of(const char* shader, std::uint32_t types, std::uint32_t texels);
    void set_storage(bool storage) { storage_ = storage; } // tables are no texel buffers here

  private:
    gpu::Device& device_;
    bool storage_ = false;
    std::map<std::tuple<std::string, std::uint32_t, std::uint32_t, bool>, gpu::ComputePipeline> made_;
};

// As large as the largest build so far.
struct BuildScratch {
    std::uint32_t items = 0, kept = 0;
    gpu::Buffer shape_boxes, boxes, bounds, keys, order, pyramid, types, type_order, ranks; // a primitive each
    gpu::Buffer ranges, flags, node_order, node_ranks;                                      // a node each
    gpu::Buffer nodes, parents;                                                             // a node each that stays
    std::array<gpu::Buffer, 3> unordered;                                                   // tables by number, by type

    void fit_items(gpu::Device& device, std::uint32_t count);
    void fit_nodes(gpu::Device& device, std::uint32_t count);
    bool all_texel() const; // of these, those that depend on the number of primitives alone
};

// EnvironmentError if a shader cannot reach so much.
gpu::Buffer make_table(gpu::Device& device, const char* name, std::size_t texels);

template <class T> gpu::Buffer filled_table(gpu::Device& device, const char* name, const std::vector<T>& values) {
    if (values.empty()) return {};
    gpu::Buffer buffer = make_table(device, name, values.size() * sizeof(T) / 16);
    gpu::upload(device, buffer, std::as_bytes(std::span(values)));
    return buffer;
}

gpu::Groups build_groups(const gpu::Device& device, std::uint32_t invocations);

} // namespace lightbench
