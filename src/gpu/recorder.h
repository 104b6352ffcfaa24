// The one place that records commands. Barriers and image layouts follow from what the passes bind; nobody writes them by hand.
// In: passes with their resources by name. Out: finished work, and the device time of every pass.
#pragma once

#include "gpu/image.h"
#include "gpu/pipeline.h"

#include <concepts>
#include <functional>
#include <string_view>
#include <variant>

namespace lightbench::gpu {

// A resource for the shader's binding of this name. Every live binding must be offered, and no name that the shader does not declare
// (both CHECKed); one that specialisation removed may be offered and is then not touched.
struct Binding {
    std::string name;
    std::variant<Buffer*, Image*> resource{};
    vk::DeviceSize offset = 0, bytes = VK_WHOLE_SIZE; // of a storage or uniform buffer; texel buffers are always bound whole
    Binding(std::string_view binding, Buffer& buffer, vk::DeviceSize from = 0, vk::DeviceSize size = VK_WHOLE_SIZE)
        : name(binding), resource(&buffer), offset(from), bytes(size) {}
    Binding(std::string_view binding, Image& image) : name(binding), resource(&image) {} // sampled images: nearest, clamped
};
using Bindings = std::vector<Binding>;

struct Groups {
    std::uint32_t x = 1, y = 1, z = 1;
};

struct ColorTarget {
    Image* image = nullptr;
    std::optional<vk::ClearColorValue> clear{}; // absent: what is there is kept
    Image* resolve = nullptr;                   // one sample, the average of the image's samples
    bool store = true;                          // false: only the resolved image is wanted
};

struct DepthTarget {
    Image* image = nullptr;
    std::optional<float> clear{};
    bool store = true;
};

struct RenderTargets {
    std::vector<ColorTarget> colors{};
    std::optional<DepthTarget> depth{};
    vk::Rect2D area{}; // pixels; also the first scissor
};

struct DrawPass {
    std::vector<const GraphicsPipeline*> pipelines{}; // the first is bound when the pass begins; none: the pass only clears
    RenderTargets targets{};
    std::vector<Buffer*> vertex_buffers{};
    Buffer* index_buffer = nullptr;         // 32-bit
    Bindings bindings{};                    // for all pipelines
    std::optional<vk::Viewport> viewport{}; // absent: the whole target, depth 0 to 1
};

struct RecorderState;

// What a draw pass does between its begin and its end.
class DrawContext {
  public:
    void use(const GraphicsPipeline& pipeline);  // one of DrawPass::pipelines; push constants must be pushed again
    void push(std::span<const std::byte> bytes); // exactly the pipeline's push_size
    template <class T> void push(const T& value) { push(std::as_bytes(std::span(&value, 1))); }
    void scissor(vk::Rect2D rect);
    void draw(std::uint32_t vertices, std::uint32_t first = 0);
    void draw_indexed(std::uint32_t indices, std::uint32_t first = 0, std::int32_t vertex_offset = 0);

  private:
    friend class Recorder;
    DrawContext(RecorderState& recorder, const DrawPass& pass) : recorder_(recorder), pass_(pass) {}
    RecorderState& recorder_;
    const DrawPass& pass_;
    const GraphicsPipeline* pipeline_ = nullptr;
    std::vector<std::vector<vk::DescriptorSet>> sets_{}; // of each pipeline
};

struct PassTime {
    std::string name{};
    double milliseconds = 0; // device timestamps
};
using Timings = std::vector<PassTime>;

class Recorder {
  public:
    explicit Recorder(Device& device);
    Recorder(Recorder&&) noexcept;
    Recorder& operator=(Recorder&&) noexcept;
    ~Recorder();

    void compute(std::string_view name, const ComputePipeline& pipeline, const Bindings& bindings, std::span<const std::byte> push,
                 Groups groups);
    template <class T>
        requires(!std::convertible_to<const T&, std::span<const std::byte>>)
    void compute(std::string_view name, const ComputePipeline& pipeline, const Bindings& bindings, const T& push, Groups groups) {
        compute(name, pipeline, bindings, std::as_bytes(std::span(&push, 1)), groups);
    }
    void draw(std::string_view name, const DrawPass& pass, const std::function<void(DrawContext&)>& body);
    void copy(Buffer& from, Buffer& to, vk::DeviceSize bytes, vk::DeviceSize from_offset = 0, vk::DeviceSize to_offset = 0);
    void copy_to_buffer(Image& image, Buffer& buffer, vk::Rect2D rect); // tightly packed rows
    void fill(Buffer& buffer, std::uint32_t value);
    void clear(Image& image, vk::ClearColorValue color);

    // Submits, waits, and makes what was written visible to the host. The recorder can then be filled again.
    // EnvironmentError if the device is lost.
    Timings submit_and_wait();

  private:
    std::unique_ptr<RecorderState> state_;
};

} // namespace lightbench::gpu
