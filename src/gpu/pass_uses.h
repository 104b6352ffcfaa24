// Everything that one pass touches, gathered before it is recorded; then the barriers of all of it at once.
#pragma once

#include "gpu/buffer_state.h"
#include "gpu/pipeline_state.h"
#include "gpu/recorder.h"

namespace lightbench::gpu {

class PassUses {
  public:
    void add(BufferState& buffer, const Access& access);
    void add(ImageState& image, const Access& access);
    void add(const PipelineState& pipeline, const Bindings& bindings); // every live binding of the pipeline
    void add(const DrawPass& pass);                                    // targets, vertex and index buffers, bindings of all pipelines
    void record_barriers(const vk::raii::CommandBuffer& commands);     // and advances the histories

  private:
    template <class State> struct Use {
        State* resource;
        Access access;
    };
    void add_target(const Image& image, const Access& access);
    std::vector<Use<BufferState>> buffers_;
    std::vector<Use<ImageState>> images_;
};

// What is offered for this binding; CHECKs that something is, and that it is of the right kind.
const Binding& offered(const PipelineState& pipeline, const LayoutBinding& binding, const Bindings& bindings);

// CHECKs that every offered name is declared by one of the pipelines, and offered once.
void check_names(const std::vector<const PipelineState*>& pipelines, const Bindings& bindings);

vk::ImageLayout layout_for(BindingKind kind);

} // namespace lightbench::gpu
