// A run of radiosity: solves, hands out pictures and the solution on the way, and draws. Inside this room only.
#pragma once

#include "render/renderer_state.h"

namespace lightbench {

// Solves until the plan is met or somebody says stop, and draws what there is; returns the image.
gpu::Image& run_radiosity(RendererState& state, const View& view, const RenderOptions& options, RenderOutput& out);

// Plan::radiosity's hemi-cube, as large as the crop, in place of an image.
void show_hemicube(RendererState& state, const View& view, RenderOutput& out);

} // namespace lightbench
