// The vertex streams of a variant of the raster shaders. Inside this room only.
#pragma once

#include "render/raster.h"

namespace lightbench {

struct VertexStream {
    gpu::VertexLayout layout;
    gpu::Buffer GpuScene::*buffer;
};

// In the order of their bindings: what the variant's vertex stage may read, and no more.
std::vector<VertexStream> vertex_streams(const Plan& plan, const RasterVariant& variant);

} // namespace lightbench
