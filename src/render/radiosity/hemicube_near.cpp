// The passes that put analytic form factors in place of those of a hemi-cube where elements are near (HC-3).
#include "render/radiosity/hemicube_state.h"
#include "render/raster.h"
#include "render/shaders.h"

#include <algorithm>

namespace lightbench {
namespace {

using namespace gpu_layout;

// Entries of the list that a SIMD group takes at most: 32 times two walks of a thousand steps stay below the 65 535 rounds that lavapipe
// grants eight invocations, and SIMD groups that find nothing left cost little beside the rays of a hemi-cube.
constexpr std::uint32_t kEntries = 32;

std::uint32_t correct_invocations(const HemicubeState& s) {
    const std::uint64_t entries = std::uint64_t{s.request.batch} * s.elements, groups = (entries + kEntries - 1) / kEntries;
    return static_cast<std::uint32_t>((groups * s.device.info().subgroup_size + 63) / 64 * 64);
}

} // namespace

void make_near_passes(HemicubeState& s) {
    CHECK(s.request.near_rays > 0u);
    s.near_pass = gpu::make_compute(s.device, find_shader("radiosity/hemicube_near.comp"), s.constants(), sizeof(HemicubePush));
    s.correct_pass = gpu::make_compute(s.device, find_shader("radiosity/hemicube_correct.comp"), s.constants(), sizeof(RayPush));
    const auto storage = vk::BufferUsageFlagBits::eStorageBuffer;
    s.near_list = gpu::make_buffer(s.device, "near-list", std::uint64_t{s.request.batch} * s.elements * 4, storage);
    s.near_count = gpu::make_buffer(s.device, "near-count", 4, storage);
}

void record_near(gpu::Recorder& recorder, HemicubeState& s, gpu::Buffer& rows, float near_sizes, gpu::Buffer* unshot) {
    CHECK((unshot != nullptr) == s.request.shares);
    recorder.fill(s.near_count, 0);
    gpu::Bindings near{{"Counters", s.counters}, {"NearCount", s.near_count}, {"NearList", s.near_list}};
    offer_table(near, "views", s.views);
    offer_table(near, "receivers", s.receivers);
    gpu::Groups groups = groups_for(s.elements);
    groups.z = s.request.batch;
    recorder.compute("hemicube-near", s.near_pass, near, HemicubePush{s.elements, s.elements, 0, 0, near_sizes}, groups);
    gpu::Bindings correct =
        s.with_structure({{"Counters", s.counters}, {"NearCount", s.near_count}, {"NearList", s.near_list}, {"Rows", rows}});
    offer_table(correct, "views", s.views);
    offer_table(correct, "receivers", s.receivers);
    offer_table(correct, "element_corners", s.corners);
    if (unshot != nullptr) offer_table(correct, "unshot", *unshot);
    RayPush push{};
    push.count = correct_invocations(s), push.first = s.elements;
    recorder.compute("hemicube-correct", s.correct_pass, correct, push, groups_for(push.count));
    s.expected += s.elements * s.request.batch + push.count;
}

} // namespace lightbench
