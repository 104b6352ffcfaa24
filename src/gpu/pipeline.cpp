// Stages, layouts by reflection, and compute pipelines.
#include "gpu/pipeline.h"

#include "gpu/check.h"
#include "gpu/pipeline_state.h"

#include <algorithm>

namespace lightbench::gpu {

CreationTimer::CreationTimer(DeviceState& device) : device_(device), start_(std::chrono::steady_clock::now()) {}

CreationTimer::~CreationTimer() {
    device_.pipeline_milliseconds += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
}

vk::DescriptorType descriptor_type(BindingKind kind) {
    switch (kind) {
    case BindingKind::uniform_texel: return vk::DescriptorType::eUniformTexelBuffer;
    case BindingKind::storage_texel: return vk::DescriptorType::eStorageTexelBuffer;
    case BindingKind::storage_buffer: return vk::DescriptorType::eStorageBuffer;
    case BindingKind::uniform_buffer: return vk::DescriptorType::eUniformBuffer;
    case BindingKind::combined_image_sampler: return vk::DescriptorType::eCombinedImageSampler;
    case BindingKind::sampled_image: return vk::DescriptorType::eSampledImage;
    case BindingKind::storage_image: return vk::DescriptorType::eStorageImage;
    case BindingKind::sampler: return vk::DescriptorType::eSampler;
    }
    return {};
}

namespace {

Stage specialized_stage(DeviceState& device, const ShaderCode& code, const Constants& constants, std::size_t push_size) {
    const Reflection written = reflect(code.words);
    if (written.push_size != 0) CHECK(written.push_size == push_size, "push constants of {}", code.name);
    Stage stage{.shader = std::string(code.name),
                .words = apply_float_rules(device.stage_cache.specialized(code, constants), device.info.float_rules)};
    for (const ReflectedBinding& b : written.bindings) stage.declared.push_back(b.name);
    stage.reflection = reflect(stage.words);
    return stage;
}

} // namespace

// Specialising takes a tenth of a second where a shader is large; a device keeps what it has specialised.
const Stage& make_stage(DeviceState& device, const ShaderCode& code, const Constants& constants, std::size_t push_size) {
    device.used.emplace(code.name);
    ShaderCode chosen = code;
    Constants values = constants;
    if (const auto replaced = device.replaced.find(code.name); replaced != device.replaced.end()) {
        chosen.words = replaced->second;
        values.insert(device.replaced_constants.begin(), device.replaced_constants.end());
    }
    const auto [known, made] = device.stages.try_emplace({chosen.words.data(), values});
    if (made) known->second = specialized_stage(device, chosen, values, push_size);
    return known->second;
}

namespace {

// Two stages may share a binding; then it is one, and both must mean the same.
void add_binding(PipelineState& s, const ReflectedBinding& b, vk::ShaderStageFlagBits stage) {
    CHECK(b.count == 1u, "{}: binding \"{}\" is an array", s.name, b.name);
    for (LayoutBinding& known : s.bindings) {
        if (known.set != b.set || known.binding != b.binding) continue;
        CHECK(known.kind == b.kind, "{}: binding \"{}\"", s.name, b.name);
        CHECK(known.name == b.name, "{}: set {}, binding {}", s.name, b.set, b.binding);
        known.stages |= stage;
        known.read |= b.read;
        known.written |= b.written;
        return;
    }
    s.bindings.push_back({b, stage});
}

void make_set_layouts(PipelineState& s) {
    const std::uint32_t sets = s.bindings.empty() ? 0 : s.bindings.back().set + 1;
    for (std::uint32_t set = 0; set < sets; ++set) {
        std::vector<vk::DescriptorSetLayoutBinding> rows;
        for (const LayoutBinding& b : s.bindings)
            if (b.set == set)
                rows.push_back(
                    {.binding = b.binding, .descriptorType = descriptor_type(b.kind), .descriptorCount = 1, .stageFlags = b.stages});
        s.set_layouts.emplace_back(
            s.device->device,
            vk::DescriptorSetLayoutCreateInfo{.bindingCount = static_cast<std::uint32_t>(rows.size()), .pBindings = rows.data()});
        set_name(*s.device, *s.set_layouts.back(), s.name);
    }
}

} // namespace

void make_layouts(PipelineState& s) {
    for (const Stage& stage : s.stages) {
        for (const ReflectedBinding& b : stage.reflection.bindings) add_binding(s, b, stage.reflection.stage);
        if (stage.reflection.push_size != 0) s.push_stages |= stage.reflection.stage;
    }
    std::ranges::sort(s.bindings, {}, [](const LayoutBinding& b) { return std::pair(b.set, b.binding); });
    make_set_layouts(s);
    std::vector<vk::DescriptorSetLayout> sets;
    for (const auto& layout : s.set_layouts) sets.push_back(*layout);
    CHECK(s.push_size <= s.device->info.max_push_bytes, "{}", s.name);
    const vk::PushConstantRange push{.stageFlags = s.push_stages, .size = static_cast<std::uint32_t>(s.push_size)};
    s.layout = {s.device->device, vk::PipelineLayoutCreateInfo{.setLayoutCount = static_cast<std::uint32_t>(sets.size()),
                                                               .pSetLayouts = sets.data(),
                                                               .pushConstantRangeCount = s.push_stages ? 1u : 0u,
                                                               .pPushConstantRanges = &push}};
    set_name(*s.device, *s.layout, s.name);
}

ComputePipeline::ComputePipeline() = default;
ComputePipeline::ComputePipeline(ComputePipeline&&) noexcept = default;
ComputePipeline& ComputePipeline::operator=(ComputePipeline&&) noexcept = default;
ComputePipeline::~ComputePipeline() = default;
const Stage& ComputePipeline::stage() const {
    return state_->stages.front();
}

ComputePipeline make_compute(Device& device, const ShaderCode& code, const Constants& constants, std::size_t push_size) {
    ComputePipeline pipeline;
    pipeline.state_ = std::make_unique<PipelineState>();
    PipelineState& s = *pipeline.state_;
    s.device = &device.state();
    s.name = code.name;
    s.push_size = push_size;
    const CreationTimer timer(*s.device);
    s.stages.push_back(make_stage(device.state(), code, constants, push_size));
    guarded("making the pipeline " + s.name, [&] {
        make_layouts(s);
        const std::vector<std::uint32_t>& words = s.stages.front().words;
        const vk::raii::ShaderModule module(s.device->device, {.codeSize = words.size() * 4, .pCode = words.data()});
        const vk::PipelineShaderStageCreateInfo stage{.stage = vk::ShaderStageFlagBits::eCompute, .module = *module, .pName = "main"};
        s.pipeline = {s.device->device, s.device->cache, vk::ComputePipelineCreateInfo{.stage = stage, .layout = *s.layout}};
    });
    set_name(*s.device, *s.pipeline, s.name);
    return pipeline;
}

} // namespace lightbench::gpu
