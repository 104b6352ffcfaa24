// Frames of traced rays, and layers of them.
#include "render/ray_frames.h"

#include "shared/effects.h"
#include "shared/rays.h"

#include <cmath>
#include <utility>

namespace lightbench {

using namespace gpu_layout;

namespace {

// Frame i of a tracer: one sample a pixel, or as many as it takes. False: stopped early.
bool trace_pass(RendererState& s, const RayWork& work, const View& view, unsigned i, const glm::vec3& background, gpu::Image& image) {
    const auto n = static_cast<unsigned>(std::lround(std::sqrt(double(s.plan.frames))));
    RayFrame frame{view, s.plan.crop, glm::vec2(0.5f), 0, i, s.environment.ambient, background};
    frame.cell = s.plan.jittered ? 1.0f / float(n) : 0;
    frame.shift = (glm::vec2(i % n, i / n) + (s.plan.jittered ? 0.0f : 0.5f)) / float(n);
    if (s.lattice) return trace_adaptive(*s.tracer, work, frame, *s.lattice, image);
    if (s.filter) return trace_filtered(*s.tracer, work, frame, *s.filter, image);
    const bool whole = trace_frame(*s.tracer, work, frame, s.targets.resolved);
    if (s.sum && (whole || i == 0)) // a frame that is not whole would darken the mean of the others
        record_accumulate(s.recorder, s.display, s.targets.resolved, s.sum, 1.0f / float(i + 1),
                          i == 0 ? ACCUMULATE_FIRST : ACCUMULATE_MEAN);
    return whole;
}

// What a layer is traced with in place of the plan: its part of the mask, unless all that arrives by its rays counts.
Plan plan_for(const Plan& whole, const Term& term, bool arriving) {
    Plan plan = whole;
    if (!arriving) plan.effects &= term.effects;
    const bool lit = plan.effects & (EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT);
    if (!lit || term.output == OUTPUT_ATTENUATION) plan.ray_effects &= ~(RAY_SHADOWS | RAY_CLEAR_SHADOWS);
    plan.ray_effects &= ~RAY_COUNT;
    return plan;
}

// The term's own surfaces, or with `arriving` what comes back by the rays that they send on.
ImageF trace_part(RendererState& s, const View& view, const RenderOptions& options, const Term& term, bool arriving) {
    const Plan plan = plan_for(s.plan, term, arriving);
    auto pipelines = std::exchange(s.tracer->pipelines, {}); // they are told apart by what a plan decides once
    const RayStatistics counts = s.tracer->counts;
    gpu::Timings times;
    RayWork work{s.device, s.recorder, plan, s.scene, s.geometry, times, {}, options.stop};
    work.output = term.output, work.parts = arriving ? term.rays : 1u << kRayEye;
    const glm::vec3 background = term.background || arriving ? s.environment.background : glm::vec3(0);
    gpu::Image* image = s.sum ? &s.sum : &s.targets.resolved;
    if (term.averaged) {
        for (unsigned i = 0; i < plan.frames && trace_pass(s, work, view, i, background, *image); ++i) {
        }
    } else {
        image = &s.targets.resolved;
        trace_frame(*s.tracer, work, {view, plan.crop, glm::vec2(0.5f), 0, 0, s.environment.ambient, background}, *image);
    }
    s.recorder.submit_and_wait();
    s.tracer->pipelines = std::move(pipelines), s.tracer->counts = counts;
    return read_crop(s, *image);
}

// RAY_... of the rays that a term counts.
std::uint32_t rays_of(const Term& term) {
    std::uint32_t rays = 0;
    if (term.rays & 1u << kRayReflected) rays |= RAY_REFLECTED;
    if (term.rays & 1u << kRayRefracted) rays |= RAY_REFRACTED | RAY_STRAIGHT;
    return rays;
}

} // namespace

gpu::Image& record_rays(RendererState& s, const View& view, const RenderOptions& options, RenderOutput& out) {
    s.tracer->counts = {};
    gpu::Image& image = s.sum ? s.sum : s.targets.resolved;
    unsigned i = 0;
    const auto progress = [&](double share) {
        out.done = (i + share) / s.plan.frames;
        if (options.progress) options.progress(out.done);
    };
    RayWork work{s.device, s.recorder, s.plan, s.scene, s.geometry, s.times, progress, options.stop};
    if (has_no_image(s.plan)) work.display = &s.display;
    RayFrame nothing{view, s.plan.crop};
    if (s.lattice) nothing.points = &s.lattice->points, nothing.lattice = &s.lattice->radiance;
    if (work.display)
        clear_pixels(s.recorder, s.display); // what a frame that is stopped early does not reach
    else
        s.recorder.clear(s.targets.resolved, {});
    warm_up(*s.tracer, work, nothing, s.targets.resolved);
    out.done = 0;
    for (; i < s.plan.frames && trace_pass(s, work, view, i, s.environment.background, image); ++i) {
        if (!options.pass || i + 1 == s.plan.frames) continue;
        RenderOutput so_far;
        read_output(s, image, so_far);
        options.pass(so_far);
    }
    return image;
}

Layer trace_layer(RendererState& s, const View& view, const RenderOptions& options, const Term& term) {
    const bool own = term.effects != 0, arriving = s.plan.ray_effects & rays_of(term);
    Layer layer{std::string(term.name), trace_part(s, view, options, term, !own)};
    if (own && arriving) {
        const ImageF more = trace_part(s, view, options, term, true);
        for (std::size_t i = 0; i < more.rgba.size(); ++i) layer.image.rgba[i] += i % 4 == 3 ? 0 : more.rgba[i];
    }
    return layer;
}

} // namespace lightbench
