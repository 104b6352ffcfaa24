// Draw passes: dynamic rendering into the targets, with one pipeline or several.
#include "gpu/check.h"
#include "gpu/recorder_state.h"

#include <algorithm>

namespace lightbench::gpu {
namespace {

// Whole vertex buffers must be there for what the pipelines read.
void check_pass(std::string_view name, const DrawPass& pass) {
    std::vector<const PipelineState*> states;
    for (const GraphicsPipeline* pipeline : pass.pipelines) {
        const PipelineState& p = pipeline->state();
        states.push_back(&p);
        for (std::size_t i = 0; i < p.reads_vertex_buffer.size(); ++i) {
            if (!p.reads_vertex_buffer[i]) continue;
            CHECK(i < pass.vertex_buffers.size(), "{}: {} reads more vertex buffers than are bound", name, p.name);
            CHECK(pass.vertex_buffers[i] != nullptr, "{}: {} reads vertex buffer {}", name, p.name, i);
        }
    }
    if (!states.empty()) check_names(states, pass.bindings);
}

vk::RenderingAttachmentInfo color_attachment(const ColorTarget& target) {
    vk::RenderingAttachmentInfo info{.imageView = *target.image->state().view,
                                     .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                     .loadOp = target.clear ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad,
                                     .storeOp = target.store ? vk::AttachmentStoreOp::eStore : vk::AttachmentStoreOp::eDontCare};
    if (target.clear) info.clearValue.color = *target.clear;
    if (target.resolve) {
        info.resolveMode = vk::ResolveModeFlagBits::eAverage;
        info.resolveImageView = *target.resolve->state().view;
        info.resolveImageLayout = vk::ImageLayout::eColorAttachmentOptimal;
    }
    return info;
}

vk::RenderingAttachmentInfo depth_attachment(const DepthTarget& target) {
    vk::RenderingAttachmentInfo info{.imageView = *target.image->state().view,
                                     .imageLayout = vk::ImageLayout::eDepthStencilAttachmentOptimal,
                                     .loadOp = target.clear ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad,
                                     .storeOp = target.store ? vk::AttachmentStoreOp::eStore : vk::AttachmentStoreOp::eDontCare};
    if (target.clear) info.clearValue.depthStencil = vk::ClearDepthStencilValue{*target.clear, 0};
    return info;
}

vk::Extent2D target_extent(const RenderTargets& targets) {
    return targets.colors.empty() ? targets.depth->image->extent() : targets.colors.front().image->extent();
}

void begin_rendering(const vk::raii::CommandBuffer& commands, const DrawPass& pass) {
    std::vector<vk::RenderingAttachmentInfo> colors;
    for (const ColorTarget& target : pass.targets.colors) colors.push_back(color_attachment(target));
    vk::RenderingAttachmentInfo depth;
    if (pass.targets.depth) depth = depth_attachment(*pass.targets.depth);
    commands.beginRendering({.renderArea = pass.targets.area,
                             .layerCount = 1,
                             .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
                             .pColorAttachments = colors.data(),
                             .pDepthAttachment = pass.targets.depth ? &depth : nullptr});
    const vk::Extent2D extent = target_extent(pass.targets);
    const vk::Viewport whole{0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
    commands.setViewport(0, pass.viewport.value_or(whole));
    commands.setScissor(0, pass.targets.area);
}

void bind_buffers(const vk::raii::CommandBuffer& commands, const DrawPass& pass) {
    for (std::uint32_t i = 0; i < pass.vertex_buffers.size(); ++i)
        if (const Buffer* buffer = pass.vertex_buffers[i]) commands.bindVertexBuffers(i, buffer->state().handle, vk::DeviceSize{0});
    if (pass.index_buffer) commands.bindIndexBuffer(pass.index_buffer->state().handle, 0, vk::IndexType::eUint32);
}

} // namespace

void Recorder::draw(std::string_view name, const DrawPass& pass, const std::function<void(DrawContext&)>& body) {
    check_pass(name, pass);
    PassUses uses;
    uses.add(pass);
    guarded(fmt::format("recording the pass {}", name), [&] {
        DrawContext context(*state_, pass);
        for (const GraphicsPipeline* pipeline : pass.pipelines)
            context.sets_.push_back(state_->descriptors.make_sets(pipeline->state(), pass.bindings));
        begin_pass(*state_, name, uses);
        begin_rendering(state_->commands, pass);
        bind_buffers(state_->commands, pass);
        if (!pass.pipelines.empty()) context.use(*pass.pipelines.front());
        body(context);
        state_->commands.endRendering();
        end_pass(*state_);
    });
}

void DrawContext::use(const GraphicsPipeline& pipeline) {
    const auto found = std::ranges::find(pass_.pipelines, &pipeline);
    CHECK(found != pass_.pipelines.end(), "{} is not a pipeline of this pass", pipeline.state().name);
    pipeline_ = &pipeline;
    const PipelineState& p = pipeline.state();
    const auto& sets = sets_[static_cast<std::size_t>(found - pass_.pipelines.begin())];
    recorder_.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *p.pipeline);
    if (!sets.empty()) recorder_.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *p.layout, 0, sets, {});
}

void DrawContext::push(std::span<const std::byte> bytes) {
    const PipelineState& p = pipeline_->state();
    CHECK(bytes.size() == p.push_size, "push constants of {}", p.name);
    if (!p.push_stages) return;
    recorder_.commands.pushConstants<std::byte>(*p.layout, p.push_stages, 0, {static_cast<std::uint32_t>(bytes.size()), bytes.data()});
}

void DrawContext::scissor(vk::Rect2D rect) {
    recorder_.commands.setScissor(0, rect);
}

void DrawContext::draw(std::uint32_t vertices, std::uint32_t first) {
    recorder_.commands.draw(vertices, 1, first, 0);
}

void DrawContext::draw_indexed(std::uint32_t indices, std::uint32_t first, std::int32_t vertex_offset) {
    CHECK(pass_.index_buffer != nullptr, "{}", pipeline_->state().name);
    recorder_.commands.drawIndexed(indices, 1, first, vertex_offset, 0);
}

} // namespace lightbench::gpu
