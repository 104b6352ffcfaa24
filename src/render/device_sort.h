// Words put in order on the device: stable counting passes over 8-bit digits (shaders/accel/sort.glsl). In: buffers of words, whole numbers
// of texels. Out: them in order, recorded; nothing is submitted here.
#pragma once

#include "gpu/recorder.h"

#include <map>
#include <tuple>

namespace lightbench {

class DeviceSort {
  public:
    explicit DeviceSort(gpu::Device& device) : device_(device) {}

    // Room for up to `most` elements. `storage`: buffers of so many words are no texel buffers here.
    void fit(std::uint32_t most, bool storage);

    // `keys` ascending; `order` tells which element each was before: equal keys stay in that order.
    void sort(gpu::Recorder& recorder, gpu::Buffer& keys, gpu::Buffer& order, std::uint32_t count);

    // By the lowest two bits of keys: values (null: the elements' numbers) in `order`, and where each element has gone in `ranks`.
    void part(gpu::Recorder& recorder, gpu::Buffer& keys, gpu::Buffer* values, gpu::Buffer& order, gpu::Buffer& ranks, std::uint32_t count);

    // Of what was parted last, once it has run: elements whose digit was 0.
    std::uint32_t zeros(gpu::Device& device);

  private:
    struct Cut;
    static Cut cut(std::uint32_t count);
    enum class Kind : std::uint32_t { count, scan, move };
    const gpu::ComputePipeline& pipeline(Kind kind, std::uint32_t digits, std::uint32_t moves = 0);
    void pass(gpu::Recorder& recorder, const Cut& cut, std::uint32_t shift, std::uint32_t digits, std::uint32_t moves,
              gpu::Bindings bindings);

    gpu::Device& device_;
    bool storage_ = false;
    gpu::Buffer keys_, order_, counts_, offsets_;
    std::map<std::tuple<Kind, std::uint32_t, std::uint32_t>, gpu::ComputePipeline> pipelines_; // by kind, digits, MOVE_...
    std::uint32_t lanes_ = 0;                                                                  // of the last pass
};

// A buffer of words, read four a texel.
gpu::Buffer make_words(gpu::Device& device, const char* name, std::size_t words);

} // namespace lightbench
