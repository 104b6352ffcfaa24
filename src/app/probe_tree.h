// The ray tree of a pixel under any method, for `probe` and the viewer.
#pragma once

#include "render/probe.h"

namespace lightbench {

// What the rasteriser draws is followed by a tracer that goes on straight through only. Throws UserError.
Probe probe_tree(gpu::Device& device, const Scene& scene, Request request, glm::uvec2 pixel);

} // namespace lightbench
