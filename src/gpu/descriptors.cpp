// Allocates and writes descriptor sets.
#include "gpu/descriptors.h"

#include "gpu/check.h"

#include <deque>

namespace lightbench::gpu {
namespace {

constexpr std::uint32_t kSetsPerPool = 128;
constexpr std::uint32_t kOfEachKind = 512;

vk::raii::DescriptorPool make_pool(const DeviceState& device) {
    using T = vk::DescriptorType;
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const T type : {T::eUniformTexelBuffer, T::eStorageTexelBuffer, T::eStorageBuffer, T::eUniformBuffer, T::eCombinedImageSampler,
                         T::eSampledImage, T::eStorageImage, T::eSampler})
        sizes.push_back({type, kOfEachKind});
    return {device.device, vk::DescriptorPoolCreateInfo{.maxSets = kSetsPerPool,
                                                        .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                                        .pPoolSizes = sizes.data()}};
}

// What the writes point to; deques, so that it stays where it is.
struct Writes {
    std::deque<vk::DescriptorBufferInfo> buffers;
    std::deque<vk::DescriptorImageInfo> images;
    std::deque<vk::BufferView> views;
    std::vector<vk::WriteDescriptorSet> rows;
};

void write_buffer(Writes& writes, vk::WriteDescriptorSet row, const DeviceState& device, const LayoutBinding& b, const Binding& resource) {
    const BufferState& s = std::get<Buffer*>(resource.resource)->state();
    if (b.kind == BindingKind::uniform_texel || b.kind == BindingKind::storage_texel) {
        row.pTexelBufferView = &writes.views.emplace_back(*s.view);
        writes.rows.push_back(row);
        return;
    }
    const vk::DeviceSize bytes = resource.bytes == VK_WHOLE_SIZE ? s.size - resource.offset : resource.bytes;
    CHECK(resource.offset + bytes <= s.size, "buffer \"{}\"", s.name);
    CHECK(bytes >= b.block_size, "buffer \"{}\" is too small for the block \"{}\"", s.name, b.name);
    if (b.kind == BindingKind::storage_buffer && bytes > device.info.max_storage_range)
        throw EnvironmentError(fmt::format("buffer \"{}\" has {}, but a shader on the device {} reaches only {}", s.name, show_bytes(bytes),
                                           device.info.name, show_bytes(device.info.max_storage_range)));
    row.pBufferInfo = &writes.buffers.emplace_back(vk::DescriptorBufferInfo{s.handle, resource.offset, bytes});
    writes.rows.push_back(row);
}

void write_image(Writes& writes, vk::WriteDescriptorSet row, const DeviceState& device, const LayoutBinding& b, const Binding& resource) {
    const ImageState& s = std::get<Image*>(resource.resource)->state();
    row.pImageInfo = &writes.images.emplace_back(vk::DescriptorImageInfo{*device.nearest, *s.view, layout_for(b.kind)});
    writes.rows.push_back(row);
}

} // namespace

vk::DescriptorSet Descriptors::allocate(vk::DescriptorSetLayout layout) {
    for (;; ++current_) {
        const bool fresh = current_ == pools_.size();
        if (fresh) pools_.push_back(make_pool(device_));
        const vk::DescriptorSetAllocateInfo info{.descriptorPool = *pools_[current_], .descriptorSetCount = 1, .pSetLayouts = &layout};
        try {
            return (*device_.device).allocateDescriptorSets(info, *device_.device.getDispatcher()).front();
        } catch (const vk::OutOfPoolMemoryError&) {
            if (fresh) throw;
        } catch (const vk::FragmentedPoolError&) {
            if (fresh) throw;
        }
    }
}

std::vector<vk::DescriptorSet> Descriptors::make_sets(const PipelineState& pipeline, const Bindings& bindings) {
    std::vector<vk::DescriptorSet> sets;
    for (const vk::raii::DescriptorSetLayout& layout : pipeline.set_layouts) sets.push_back(allocate(*layout));
    Writes writes;
    for (const LayoutBinding& b : pipeline.bindings) {
        const vk::WriteDescriptorSet row{
            .dstSet = sets[b.set], .dstBinding = b.binding, .descriptorCount = 1, .descriptorType = descriptor_type(b.kind)};
        if (b.kind == BindingKind::sampler) {
            writes.rows.push_back(row);
            writes.rows.back().pImageInfo = &writes.images.emplace_back(vk::DescriptorImageInfo{*device_.nearest});
            continue;
        }
        const Binding& resource = offered(pipeline, b, bindings);
        if (std::holds_alternative<Image*>(resource.resource))
            write_image(writes, row, device_, b, resource);
        else
            write_buffer(writes, row, device_, b, resource);
    }
    device_.device.updateDescriptorSets(writes.rows, {});
    return sets;
}

void Descriptors::reset() {
    for (vk::raii::DescriptorPool& pool : pools_) pool.reset();
    current_ = 0;
}

} // namespace lightbench::gpu
