// From what a pass binds to how it touches it.
#include "gpu/pass_uses.h"

#include "gpu/check.h"

#include <algorithm>

namespace lightbench::gpu {
namespace {

using Stage2 = vk::PipelineStageFlagBits2;
using Access2 = vk::AccessFlagBits2;

vk::PipelineStageFlags2 stages_of(vk::ShaderStageFlags stages) {
    vk::PipelineStageFlags2 result;
    if (stages & vk::ShaderStageFlagBits::eVertex) result |= Stage2::eVertexShader;
    if (stages & vk::ShaderStageFlagBits::eFragment) result |= Stage2::eFragmentShader;
    if (stages & vk::ShaderStageFlagBits::eCompute) result |= Stage2::eComputeShader;
    return result;
}

vk::AccessFlags2 reading(BindingKind kind) {
    switch (kind) {
    case BindingKind::uniform_buffer: return Access2::eUniformRead;
    case BindingKind::storage_buffer:
    case BindingKind::storage_texel:
    case BindingKind::storage_image: return Access2::eShaderStorageRead;
    default: return Access2::eShaderSampledRead;
    }
}

Access access_of(const LayoutBinding& binding, vk::ImageLayout layout) {
    Access access{stages_of(binding.stages), {}, binding.written, layout};
    if (binding.read) access.access |= reading(binding.kind);
    if (binding.written) access.access |= Access2::eShaderStorageWrite;
    return access;
}

bool is_image(BindingKind kind) {
    return kind == BindingKind::storage_image || kind == BindingKind::sampled_image || kind == BindingKind::combined_image_sampler;
}

} // namespace

vk::ImageLayout layout_for(BindingKind kind) {
    return kind == BindingKind::storage_image ? vk::ImageLayout::eGeneral : vk::ImageLayout::eShaderReadOnlyOptimal;
}

const Binding& offered(const PipelineState& pipeline, const LayoutBinding& binding, const Bindings& bindings) {
    const auto found = std::ranges::find(bindings, binding.name, &Binding::name);
    CHECK(found != bindings.end(), "{} reads the {} \"{}\", which the pass does not bind", pipeline.name, to_string(binding.kind),
          binding.name);
    const bool image = std::holds_alternative<Image*>(found->resource);
    CHECK(image == is_image(binding.kind), "{}: \"{}\" is a {}", pipeline.name, binding.name, to_string(binding.kind));
    if (binding.kind == BindingKind::uniform_texel || binding.kind == BindingKind::storage_texel) {
        const Buffer& buffer = *std::get<Buffer*>(found->resource);
        CHECK(buffer.as_texel(), "{}: \"{}\" is a {}, but buffer \"{}\" has no texel view", pipeline.name, binding.name,
              to_string(binding.kind), buffer.name());
    }
    return *found;
}

void check_names(const std::vector<const PipelineState*>& pipelines, const Bindings& bindings) {
    for (const Binding& b : bindings) {
        bool declared = false;
        for (const PipelineState* pipeline : pipelines)
            for (const Stage& stage : pipeline->stages) declared |= std::ranges::find(stage.declared, b.name) != stage.declared.end();
        CHECK(declared, "{} declares no binding \"{}\"", pipelines.front()->name, b.name);
        CHECK(std::ranges::count(bindings, b.name, &Binding::name) == 1, "{}: \"{}\" is bound twice", pipelines.front()->name, b.name);
    }
}

void PassUses::add(BufferState& buffer, const Access& access) {
    const auto known = std::ranges::find(buffers_, &buffer, &Use<BufferState>::resource);
    if (known != buffers_.end()) return known->access.merge(access);
    buffers_.push_back({&buffer, access});
}

void PassUses::add(ImageState& image, const Access& access) {
    const auto known = std::ranges::find(images_, &image, &Use<ImageState>::resource);
    if (known != images_.end()) return known->access.merge(access);
    images_.push_back({&image, access});
}

void PassUses::add(const PipelineState& pipeline, const Bindings& bindings) {
    for (const LayoutBinding& b : pipeline.bindings) {
        if (b.kind == BindingKind::sampler) continue;
        const Binding& resource = offered(pipeline, b, bindings);
        if (is_image(b.kind))
            add(std::get<Image*>(resource.resource)->state(), access_of(b, layout_for(b.kind)));
        else
            add(std::get<Buffer*>(resource.resource)->state(), access_of(b, vk::ImageLayout::eUndefined));
    }
}

void PassUses::add_target(const Image& image, const Access& access) {
    add(image.state(), access);
}

void PassUses::add(const DrawPass& pass) {
    const Access color{Stage2::eColorAttachmentOutput, Access2::eColorAttachmentRead | Access2::eColorAttachmentWrite, true,
                       vk::ImageLayout::eColorAttachmentOptimal};
    const Access depth{Stage2::eEarlyFragmentTests | Stage2::eLateFragmentTests,
                       Access2::eDepthStencilAttachmentRead | Access2::eDepthStencilAttachmentWrite, true,
                       vk::ImageLayout::eDepthStencilAttachmentOptimal};
    for (const ColorTarget& target : pass.targets.colors) {
        add_target(*target.image, color);
        if (target.resolve) add_target(*target.resolve, color);
    }
    if (pass.targets.depth) add_target(*pass.targets.depth->image, depth);
    for (const Buffer* buffer : pass.vertex_buffers)
        if (buffer) add(buffer->state(), {Stage2::eVertexAttributeInput, Access2::eVertexAttributeRead});
    if (pass.index_buffer) add(pass.index_buffer->state(), {Stage2::eIndexInput, Access2::eIndexRead});
    for (const GraphicsPipeline* pipeline : pass.pipelines) add(pipeline->state(), pass.bindings);
}

void PassUses::record_barriers(const vk::raii::CommandBuffer& commands) {
    std::vector<vk::BufferMemoryBarrier2> buffers;
    std::vector<vk::ImageMemoryBarrier2> images;
    for (const auto& [buffer, access] : buffers_)
        if (const auto d = advance(buffer->history, access))
            buffers.push_back({.srcStageMask = d->from_stages,
                               .srcAccessMask = d->from_access,
                               .dstStageMask = d->to_stages,
                               .dstAccessMask = d->to_access,
                               .buffer = buffer->handle,
                               .size = VK_WHOLE_SIZE});
    for (const auto& [image, access] : images_)
        if (const auto d = advance(image->history, access))
            images.push_back({.srcStageMask = d->from_stages,
                              .srcAccessMask = d->from_access,
                              .dstStageMask = d->to_stages,
                              .dstAccessMask = d->to_access,
                              .oldLayout = d->from_layout,
                              .newLayout = d->to_layout,
                              .image = image->handle,
                              .subresourceRange = {.aspectMask = aspect_of(image->format), .levelCount = 1, .layerCount = 1}});
    if (buffers.empty() && images.empty()) return;
    commands.pipelineBarrier2({.bufferMemoryBarrierCount = static_cast<std::uint32_t>(buffers.size()),
                               .pBufferMemoryBarriers = buffers.data(),
                               .imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size()),
                               .pImageMemoryBarriers = images.data()});
}

} // namespace lightbench::gpu
