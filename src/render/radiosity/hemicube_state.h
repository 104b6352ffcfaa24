// What Hemicubes owns, for its own sources.
#pragma once

#include "gpu/check.h"
#include "render/gpu_scene.h"
#include "render/radiosity/hemicube.h"
#include "render/radiosity/hemicube_mesh.h"
#include "shared/effects.h"
#include "shared/rays.h"
#include "shared/solve.h"

namespace lightbench {

// The rasteriser's part: one image that holds the five faces one under the other, as the items are.
struct HemicubeFaces {
    gpu::Buffer vertices, indices, packed;
    gpu::Image items, depth;
    gpu::GraphicsPipeline pipeline;
    std::uint32_t index_count = 0;
};

struct HemicubeState {
    gpu::Device& device;
    HemicubeRequest request;
    std::uint32_t elements = 0, patches = 0;
    std::uint32_t fetch_storage = 0;                                 // FETCH_... bits of the tables that are no texel buffers here
    gpu::Buffer receivers{}, shooters{}, views{}, items{}, deltas{}; // tables
    gpu::Buffer nodes{}, narrow{}, triangles{}, corners{};           // of rays
    std::uint32_t effects = 0, stack = 2, loose = 0;                 // CONSTANT_RAY_EFFECTS and so on
    gpu::Buffer counters{};                                          // RayCounters
    std::uint32_t expected = 0;                                      // invocations that must have ended, modulo 2^32 as the device counts
    gpu::Buffer near_list{}, near_count{};                           // with correct_near
    gpu::ComputePipeline view_pass{}, ray_pass{}, sum_pass{}, near_pass{}, correct_pass{};
    HemicubeFaces faces{};

    std::uint32_t face_items() const { return 3 * request.resolution * request.resolution; }
    bool traces() const { return request.way == HemicubeWay::rays || request.correct_near; }
    gpu::Constants constants() const;
    gpu::Bindings with_structure(gpu::Bindings bindings);
};

// A read-only table for fetch4(); where it is no texel buffer its bit is set in state.fetch_storage.
gpu::Buffer hemicube_table(HemicubeState& state, const char* name, std::span<const std::byte> bytes, std::uint32_t bit);
gpu::Buffer empty_hemicube_table(HemicubeState& state, const char* name, std::uint64_t bytes, std::uint32_t bit);

HemicubeFaces make_faces(HemicubeState& state, const HemicubeMesh& mesh);
void record_faces(gpu::Recorder& recorder, HemicubeState& state);

void make_near_passes(HemicubeState& state);
void record_near(gpu::Recorder& recorder, HemicubeState& state, gpu::Buffer& rows, float near_sizes, gpu::Buffer* unshot);

} // namespace lightbench
