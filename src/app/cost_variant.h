// One variant of a request on the device, rendered as often as it is asked for. In: options as typed. Out: radiance and device time.
#pragma once

#include "app/options.h"
#include "app/prepare.h"
#include "measure/sweep.h"
#include "render/render.h"

namespace lightbench {

class CostVariant {
  public:
    // `options` are understood: parse_scene_options() found no problem. The device outlives it. Throws UserError.
    CostVariant(gpu::Device& device, const Scene& scene, const SceneOptions& options);
    Rendering run(); // from the beginning, whatever was rendered before; ends early, with any picture, once an Interrupt came
    const Plan& plan() const { return prepared_->plan; }

  private:
    std::unique_ptr<Prepared> prepared_; // the renderer refers to its geometry
    std::unique_ptr<Renderer> renderer_;
};

// Options of a variant, checked; problems name `where` ("--knob spp=15") before their flag.
SceneOptions parse_variant(const OptionTexts& texts, const std::string& where, Problems& problems);

} // namespace lightbench
