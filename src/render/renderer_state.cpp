#include "render/renderer_state.h"

#include "image/display.h"

#include <cmath>

namespace lightbench {
namespace {

vk::Rect2D rect_of(const Rect& crop) {
    return {{static_cast<std::int32_t>(crop.offset.x), static_cast<std::int32_t>(crop.offset.y)}, {crop.size.x, crop.size.y}};
}

} // namespace

glm::dvec2 shift_of(const Plan& plan, unsigned i) {
    const auto n = static_cast<unsigned>(std::lround(std::sqrt(double(plan.frames))));
    if (n <= 1) return glm::dvec2(0);
    const glm::dvec2 cell(i % n, i / n);
    const glm::dvec2 within = plan.jittered ? jitter(plan.seed, i) : glm::dvec2(0.5);
    return (cell + within) / double(n) - 0.5;
}

bool has_no_image(const Plan& plan) {
    return plan.method == Method::raytrace && plan.runs("display") && !plan.runs("film");
}

const RasterPipelines& pipelines_for(RendererState& s, const RasterVariant& variant) {
    auto [it, made] = s.pipelines.try_emplace(variant);
    if (made) it->second = make_raster_pipelines(s.device, s.plan, s.scene, s.geometry, variant);
    return it->second;
}

ImageF read_crop(RendererState& s, gpu::Image& image) {
    return {s.plan.crop.size.x, s.plan.crop.size.y, gpu::read_image<float>(s.device, image, rect_of(s.plan.crop))};
}

void read_output(RendererState& s, gpu::Image& image, RenderOutput& out) {
    if (s.plan.runs("display") && !has_no_image(s.plan)) record_display(s.recorder, s.display, image);
    const gpu::Timings last = s.recorder.submit_and_wait();
    s.times.insert(s.times.end(), last.begin(), last.end());
    if (s.plan.runs("display")) {
        out.pixels = read_pixels(s.device, s.display, s.plan.crop);
        out.non_finite = read_census(s.device, s.display);
        return;
    }
    out.radiance = read_crop(s, image);
    if (s.filter) // whose sum of weights is nobody's opacity
        for (std::size_t i = 3; i < out.radiance->rgba.size(); i += 4) out.radiance->rgba[i] = 1;
    out.non_finite = count_non_finite(*out.radiance);
}

} // namespace lightbench
