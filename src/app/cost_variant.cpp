#include "app/cost_variant.h"

#include "app/interrupt.h"

#include <fmt/format.h>

namespace lightbench {

CostVariant::CostVariant(gpu::Device& device, const Scene& scene, const SceneOptions& options) {
    Scene own = scene; // completing it adds a camera, a headlight, other laws
    Request request = options.request;
    request.output = Output::radiance;
    prepared_ = std::make_unique<Prepared>(prepare(own, request));
    renderer_ = std::make_unique<Renderer>(device, own, prepared_->geometry, prepared_->plan);
}

Rendering CostVariant::run() {
    RenderOptions options;
    options.anew = true;
    options.stop = Interrupt::came;
    RenderOutput output = renderer_->render(prepared_->view, options);
    return {std::move(output.radiance.value()), output.device_milliseconds};
}

SceneOptions parse_variant(const OptionTexts& texts, const std::string& where, Problems& problems) {
    Problems found;
    const SceneOptions options = parse_scene_options(texts, found);
    for (Problem& p : found) problems.push_back({where, 0, 0, p.file.empty() ? p.text : fmt::format("{}: {}", p.file, p.text)});
    return options;
}

} // namespace lightbench
