// Frames of traced rays into an image, and the layers of the terms likewise. Inside this room only.
#pragma once

#include "render/render.h"
#include "render/renderer_state.h"
#include "render/terms.h"

namespace lightbench {

// All frames of the plan; what options.stop leaves out is black. Returns the image, none if has_no_image().
gpu::Image& record_rays(RendererState& state, const View& view, const RenderOptions& options, RenderOutput& out);

// Traces once more, or twice, for what the term keeps. Depths are in frame units. What options.stop ends early is not to be used.
Layer trace_layer(RendererState& state, const View& view, const RenderOptions& options, const Term& term);

} // namespace lightbench
