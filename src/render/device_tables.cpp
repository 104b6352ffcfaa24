#include "render/device_tables.h"

#include "gpu/errors.h"
#include "render/device_sort.h"
#include "render/shaders.h"
#include "shared/effects.h"

#include <bit>

namespace lightbench {

using namespace gpu_layout;

const gpu::ComputePipeline& BuildPipelines::of(const char* shader, std::uint32_t types, std::uint32_t texels) {
    gpu::ComputePipeline& pipeline = made_[{shader, types, texels, storage_}];
    if (pipeline) return pipeline;
    const gpu::Constants constants{
        {CONSTANT_FETCH_STORAGE, storage_ ? FETCH_BUILD : 0u}, {CONSTANT_BUILD_TYPES, types}, {CONSTANT_COPY_TEXELS, texels}};
    pipeline = gpu::make_compute(device_, find_shader(shader), constants, sizeof(BuildPush));
    return pipeline;
}

gpu::Buffer make_table(gpu::Device& device, const char* name, std::size_t texels) {
    if (texels * 16 > device.info().max_storage_range)
        throw gpu::EnvironmentError(fmt::format("building on the device needs a table \"{}\" of {} MiB, but its shaders reach only {}; "
                                                "--accel-param builder=host has no such limit",
                                                name, (texels * 16) >> 20, device.info().max_storage_range >> 20));
    return gpu::make_texel_buffer(device, name, texels * 16);
}

void BuildScratch::fit_items(gpu::Device& device, std::uint32_t count) {
    items = count;
    boxes = make_table(device, "boxes", std::size_t{count} * kBoxTexels);
    bounds = gpu::make_buffer(device, "bounds", sizeof(BuildBounds), vk::BufferUsageFlagBits::eStorageBuffer, gpu::Memory::readback);
    pyramid = make_table(device, "pyramid", std::size_t{std::bit_ceil(count)} * 2 * kBoxTexels);
    ranges = make_table(device, "ranges", count);
    for (gpu::Buffer* words : {&keys, &order, &types, &type_order, &ranks, &flags, &node_order, &node_ranks})
        *words = make_words(device, "build-words", count);
}

void BuildScratch::fit_nodes(gpu::Device& device, std::uint32_t count) {
    if (count <= kept) return;
    kept = count;
    nodes = make_table(device, "build-nodes", std::size_t{count} * kBuildNodeTexels);
    parents = make_words(device, "parents", count);
}

bool BuildScratch::all_texel() const {
    return pyramid.as_texel(); // the largest of those that are read as tables
}

gpu::Groups build_groups(const gpu::Device& device, std::uint32_t invocations) {
    const std::uint32_t groups = (invocations + 63) / 64, most = device.info().max_group_count;
    if (groups <= most) return {groups};
    return {most, (groups + most - 1) / most};
}

} // namespace lightbench
