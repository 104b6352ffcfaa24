// Graphics pipelines: triangle lists, dynamic rendering, attributes that are alive.
#include "gpu/check.h"
#include "gpu/pipeline_state.h"

#include <algorithm>

namespace lightbench::gpu {

GraphicsPipeline::GraphicsPipeline() = default;
GraphicsPipeline::GraphicsPipeline(GraphicsPipeline&&) noexcept = default;
GraphicsPipeline& GraphicsPipeline::operator=(GraphicsPipeline&&) noexcept = default;
GraphicsPipeline::~GraphicsPipeline() = default;
const Stage& GraphicsPipeline::vertex() const {
    return state_->stages[0];
}
const Stage* GraphicsPipeline::fragment() const {
    return state_->stages.size() > 1 ? &state_->stages[1] : nullptr;
}

namespace {

struct VertexInput {
    std::vector<vk::VertexInputBindingDescription> bindings;
    std::vector<vk::VertexInputAttributeDescription> attributes;
};

bool is_read(const Reflection& vertex, std::uint32_t location) {
    return std::ranges::find(vertex.inputs, location, &ReflectedVariable::location) != vertex.inputs.end();
}

// Only what the specialised vertex stage reads; CHECKs that it reads nothing else.
VertexInput live_input(PipelineState& s, const GraphicsDesc& desc) {
    VertexInput input;
    const Reflection& vertex = s.stages[0].reflection;
    for (std::uint32_t i = 0; i < desc.vertex_buffers.size(); ++i) {
        const std::size_t before = input.attributes.size();
        for (const VertexAttribute& a : desc.vertex_buffers[i].attributes)
            if (is_read(vertex, a.location)) input.attributes.push_back({a.location, i, a.format, a.offset});
        s.reads_vertex_buffer.push_back(input.attributes.size() > before);
        if (s.reads_vertex_buffer.back()) input.bindings.push_back({.binding = i, .stride = desc.vertex_buffers[i].stride});
    }
    CHECK(input.attributes.size() == vertex.inputs.size(), "{}: the vertex stage reads an attribute that no vertex buffer has", s.name);
    return input;
}

// What the fragment stage does not read is not computed, and not a warning of the validation layers either.
void strip_vertex_stage(PipelineState& s) {
    Stage& vertex = s.stages[0];
    const std::span<const std::uint32_t> fragment =
        s.stages.size() > 1 ? std::span<const std::uint32_t>(s.stages[1].words) : std::span<const std::uint32_t>();
    vertex.words = s.device->stage_cache.without_unread_outputs(vertex.words, fragment);
    vertex.reflection = reflect(vertex.words);
}

// Every input of the fragment stage must be an output of the vertex stage: specialisation strips inputs only, so this is a slip of ours.
void check_interface(const PipelineState& s) {
    if (s.stages.size() < 2) return;
    for (const ReflectedVariable& in : s.stages[1].reflection.inputs) {
        const auto& outputs = s.stages[0].reflection.outputs;
        const bool written = std::ranges::find(outputs, in.location, &ReflectedVariable::location) != outputs.end();
        CHECK(written, "{}: the fragment stage reads \"{}\" at location {}, which the vertex stage does not write", s.name, in.name,
              in.location);
    }
}

vk::PipelineMultisampleStateCreateInfo multisample_state(const GraphicsDesc& desc) {
    return {.rasterizationSamples = static_cast<vk::SampleCountFlagBits>(desc.samples),
            .sampleShadingEnable = desc.sample_shading,
            .minSampleShading = 1};
}

vk::PipelineDepthStencilStateCreateInfo depth_state(const GraphicsDesc& desc) {
    const bool has_depth = desc.depth_format != vk::Format::eUndefined;
    return {.depthTestEnable = has_depth && desc.depth_test,
            .depthWriteEnable = has_depth && desc.depth_write,
            .depthCompareOp = desc.depth_compare};
}

// Pieces that must live until the pipeline is made.
struct FixedState {
    VertexInput input;
    vk::PipelineVertexInputStateCreateInfo vertex;
    vk::PipelineInputAssemblyStateCreateInfo assembly{.topology = vk::PrimitiveTopology::eTriangleList};
    vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    vk::PipelineRasterizationStateCreateInfo raster;
    vk::PipelineMultisampleStateCreateInfo multisample;
    vk::PipelineDepthStencilStateCreateInfo depth;
    std::vector<vk::PipelineColorBlendAttachmentState> blend_rows;
    vk::PipelineColorBlendStateCreateInfo blend;
    std::array<vk::DynamicState, 2> dynamic_rows{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = 2, .pDynamicStates = dynamic_rows.data()};
    vk::PipelineRenderingCreateInfo rendering;
    FixedState(PipelineState& s, const GraphicsDesc& desc);
    FixedState(const FixedState&) = delete;
};

FixedState::FixedState(PipelineState& s, const GraphicsDesc& desc) : input(live_input(s, desc)) {
    using C = vk::ColorComponentFlagBits;
    vertex = {.vertexBindingDescriptionCount = static_cast<std::uint32_t>(input.bindings.size()),
              .pVertexBindingDescriptions = input.bindings.data(),
              .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(input.attributes.size()),
              .pVertexAttributeDescriptions = input.attributes.data()};
    raster = {.cullMode = desc.cull, .frontFace = desc.front_face, .lineWidth = 1};
    multisample = multisample_state(desc);
    depth = depth_state(desc);
    blend_rows.assign(desc.color_formats.size(), {.colorWriteMask = C::eR | C::eG | C::eB | C::eA});
    blend = {.attachmentCount = static_cast<std::uint32_t>(blend_rows.size()), .pAttachments = blend_rows.data()};
    rendering = {.colorAttachmentCount = static_cast<std::uint32_t>(desc.color_formats.size()),
                 .pColorAttachmentFormats = desc.color_formats.data(),
                 .depthAttachmentFormat = desc.depth_format};
}

void build(PipelineState& s, const GraphicsDesc& desc) {
    const FixedState fixed(s, desc);
    std::vector<vk::raii::ShaderModule> modules;
    std::vector<vk::PipelineShaderStageCreateInfo> stages;
    for (const Stage& stage : s.stages) {
        modules.emplace_back(s.device->device, vk::ShaderModuleCreateInfo{.codeSize = stage.words.size() * 4, .pCode = stage.words.data()});
        stages.push_back({.stage = stage.reflection.stage, .module = *modules.back(), .pName = "main"});
    }
    const vk::GraphicsPipelineCreateInfo info{.pNext = &fixed.rendering,
                                              .stageCount = static_cast<std::uint32_t>(stages.size()),
                                              .pStages = stages.data(),
                                              .pVertexInputState = &fixed.vertex,
                                              .pInputAssemblyState = &fixed.assembly,
                                              .pViewportState = &fixed.viewport,
                                              .pRasterizationState = &fixed.raster,
                                              .pMultisampleState = &fixed.multisample,
                                              .pDepthStencilState = &fixed.depth,
                                              .pColorBlendState = &fixed.blend,
                                              .pDynamicState = &fixed.dynamic,
                                              .layout = *s.layout};
    s.pipeline = {s.device->device, s.device->cache, info};
}

} // namespace

GraphicsPipeline make_graphics(Device& device, const GraphicsDesc& desc) {
    GraphicsPipeline pipeline;
    pipeline.state_ = std::make_unique<PipelineState>();
    PipelineState& s = *pipeline.state_;
    s.device = &device.state();
    s.name = desc.name;
    s.push_size = desc.push_size;
    const CreationTimer timer(*s.device);
    s.stages.push_back(make_stage(device.state(), desc.vertex, desc.constants, desc.push_size));
    if (desc.fragment) s.stages.push_back(make_stage(device.state(), *desc.fragment, desc.constants, desc.push_size));
    strip_vertex_stage(s);
    check_interface(s);
    guarded("making the pipeline " + s.name, [&] {
        make_layouts(s);
        build(s, desc);
    });
    set_name(*s.device, *s.pipeline, s.name);
    return pipeline;
}

} // namespace lightbench::gpu
