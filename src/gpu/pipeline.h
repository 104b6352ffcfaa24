// Pipelines from embedded shaders: specialised, reflected, laid out by what is left, built through the disk cache.
// In: ShaderCode, constants and fixed-function state. Out: an owned pipeline that knows its bindings by name.
#pragma once

#include "gpu/device.h"
#include "gpu/reflect.h"
#include "gpu/specialize.h"

#include <optional>

namespace lightbench::gpu {

// One specialised stage, kept for tests and for matching names.
struct Stage {
    std::string shader{};                // path of the GLSL file
    std::vector<std::uint32_t> words{};  // specialised
    Reflection reflection{};             // of the specialised words
    std::vector<std::string> declared{}; // names of all bindings before specialisation: these may be offered, even where they are dead now
};

struct PipelineState;

class ComputePipeline {
  public:
    ComputePipeline(); // none
    ComputePipeline(ComputePipeline&&) noexcept;
    ComputePipeline& operator=(ComputePipeline&&) noexcept;
    ~ComputePipeline();
    explicit operator bool() const { return state_ != nullptr; }
    const Stage& stage() const;
    std::array<std::uint32_t, 3> local_size() const { return stage().reflection.local_size; }
    PipelineState& state() const { return *state_; } // for this room
  private:
    friend ComputePipeline make_compute(Device&, const ShaderCode&, const Constants&, std::size_t);
    std::unique_ptr<PipelineState> state_;
};

// push_size: bytes of the C++ struct that will be pushed, 0 for none; CHECKed against the shader's block as it was written.
ComputePipeline make_compute(Device& device, const ShaderCode& code, const Constants& constants, std::size_t push_size);

struct VertexAttribute {
    std::uint32_t location = 0;
    vk::Format format{};
    std::uint32_t offset = 0; // bytes from the start of the vertex
};

struct VertexLayout {
    std::uint32_t stride = 0;                  // bytes
    std::vector<VertexAttribute> attributes{}; // those that the specialised vertex stage does not read are left out
};

struct GraphicsDesc {
    std::string name{}; // for people and debuggers
    ShaderCode vertex{};
    std::optional<ShaderCode> fragment{};       // absent: depth only
    Constants constants{};                      // of both stages
    std::size_t push_size = 0;                  // bytes of the C++ struct that will be pushed, 0 for none
    std::vector<VertexLayout> vertex_buffers{}; // in the order of DrawPass::vertex_buffers
    std::vector<vk::Format> color_formats{};
    vk::Format depth_format = vk::Format::eUndefined;
    unsigned samples = 1;
    bool sample_shading = false; // the fragment stage runs once a sample
    vk::CullModeFlags cull = vk::CullModeFlagBits::eNone;
    vk::FrontFace front_face = vk::FrontFace::eCounterClockwise;
    bool depth_test = true, depth_write = true;
    vk::CompareOp depth_compare = vk::CompareOp::eGreater; // reversed z: the far plane is 0
};

class GraphicsPipeline {
  public:
    GraphicsPipeline(); // none
    GraphicsPipeline(GraphicsPipeline&&) noexcept;
    GraphicsPipeline& operator=(GraphicsPipeline&&) noexcept;
    ~GraphicsPipeline();
    explicit operator bool() const { return state_ != nullptr; }
    const Stage& vertex() const;
    const Stage* fragment() const;                   // null: depth only
    PipelineState& state() const { return *state_; } // for this room
  private:
    friend GraphicsPipeline make_graphics(Device&, const GraphicsDesc&);
    std::unique_ptr<PipelineState> state_;
};

// Triangle lists; viewport and scissor are set by the pass.
GraphicsPipeline make_graphics(Device& device, const GraphicsDesc& desc);

} // namespace lightbench::gpu
