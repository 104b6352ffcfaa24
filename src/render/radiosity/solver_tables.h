// The solvers' tables: made from values, read back as values. Inside this room only.
#pragma once

#include "gpu/recorder.h"

namespace lightbench {

// T: a struct of whole texels. Not empty.
template <class T> gpu::Buffer make_table(gpu::Device& device, const char* name, const std::vector<T>& values) {
    gpu::Buffer buffer = gpu::make_texel_buffer(device, name, values.size() * sizeof(T));
    gpu::upload(device, buffer, std::as_bytes(std::span(values)));
    return buffer;
}

// As gpu::download_all(), which does not know that glm's vectors are plain bytes.
template <class T> std::vector<T> read_table(gpu::Device& device, gpu::Buffer& buffer) {
    std::vector<T> values(buffer.size() / sizeof(T));
    gpu::download(device, buffer, std::as_writable_bytes(std::span(values)));
    return values;
}

} // namespace lightbench
