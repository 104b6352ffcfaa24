// Runs a plan: every frame and every piece of the lights, then the display; the layers of the terms likewise.
#include "render/render.h"

#include "gpu/errors.h"
#include "gpu/float64.h"
#include "gpu/recorder.h"
#include "image/display.h"
#include "render/radiosity/run.h"
#include "render/ray_frames.h"
#include "render/renderer_state.h"
#include "render/terms.h"
#include "shared/effects.h"
#include "shared/rays.h"

#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace lightbench {

namespace {

struct Drawing {
    RasterVariant variant;
    glm::vec3 background{0};
    std::string name = "raster";
    bool background_map = false;
};

RasterTargets& targets_for(RendererState& s, const RasterVariant& variant) {
    if (variant.samples == s.plan.multisamples) return s.targets;
    if (!s.single.resolved) s.single = make_targets(s.device, s.plan.size, 1, "layer");
    return s.single;
}

gpu::Device& device_for(const Plan& plan, gpu::Device& device) {
    if (plan.precision == Precision::float64 && !gpu::has_float64(device))
        throw gpu::EnvironmentError(
            fmt::format("{} does not compute in float64; it must be --precision float32, or another --device", device.info().name));
    return device;
}

// One frame, one piece of the lights. Emission, ambient light and the background belong to the first piece.
std::size_t record_piece(RendererState& s, const View& view, Drawing drawing, unsigned frame, std::size_t piece) {
    RasterDraw draw{view, shift_of(s.plan, frame), s.environment.ambient, drawing.background,
                    0,    s.scene.light_count,     drawing.name,          drawing.background_map && piece == 0};
    if (s.plan.light_passes > 1) {
        draw.first_light = static_cast<std::uint32_t>(piece * kLightsPerPass);
        draw.end_light = static_cast<std::uint32_t>(std::min<std::size_t>((piece + 1) * kLightsPerPass, s.scene.light_count));
    }
    if (piece > 0)
        drawing.variant.effects &= ~(EFFECT_EMISSION | EFFECT_AMBIENT | EFFECT_MIRROR_ENVIRONMENT), draw.background = glm::vec3(0);
    RasterTargets& targets = targets_for(s, drawing.variant);
    const RasterPipelines& pipelines = pipelines_for(s, drawing.variant);
    const std::size_t opaque = record_raster(s.recorder, s.plan, s.scene, s.geometry, drawing.variant, pipelines, targets, draw);
    if (!drawing.variant.has_layers()) return opaque;
    return opaque +
           record_layers(s.layers, {s.device, s.recorder, s.plan, s.scene, s.geometry, drawing.variant, pipelines, targets, draw, s.times});
}

// All frames and pieces, into the image that is returned.
gpu::Image& record_drawing(RendererState& s, const View& view, const Drawing& drawing, std::size_t& triangles) {
    RasterTargets& targets = targets_for(s, drawing.variant);
    const bool whole = &targets == &s.targets && s.sum;
    const unsigned frames = whole ? s.plan.frames : 1;
    const std::size_t pieces = whole ? s.plan.light_passes : 1;
    triangles = 0;
    for (unsigned frame = 0; frame < frames; ++frame)
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            triangles += record_piece(s, view, drawing, frame, piece);
            if (whole)
                record_accumulate(s.recorder, s.display, targets.resolved, s.sum, 1.0f / float(frames),
                                  frame == 0 && piece == 0 ? ACCUMULATE_FIRST : ACCUMULATE_ADD);
        }
    return whole ? s.sum : targets.resolved;
}

void add_times(RenderOutput& out, const gpu::Timings& timings) {
    for (const auto& [name, ms] : timings) {
        auto it = std::ranges::find(out.times, name, &StepTime::name);
        if (it == out.times.end())
            out.times.push_back({name, ms});
        else
            it->milliseconds += ms;
        out.device_milliseconds += ms;
    }
}

RenderOutput run_image(RendererState& s, const View& view, const RenderOptions& options) {
    RenderOutput out;
    const Drawing drawing{{s.plan.effects, OUTPUT_RADIANCE, s.plan.multisamples}, s.environment.background, "raster", true};
    s.times.clear();
    if (s.plan.runs("unfold")) return show_hemicube(s, view, out), add_times(out, s.times), out;
    gpu::Image& image = s.tracer      ? record_rays(s, view, options, out)
                        : s.radiosity ? run_radiosity(s, view, options, out)
                                      : record_drawing(s, view, drawing, out.triangles_drawn);
    read_output(s, image, out);
    if (s.scene.cube_milliseconds > 0) add_times(out, {{"environment-cube", s.scene.cube_milliseconds}});
    add_times(out, s.times);
    if (s.tracer) {
        const AccelTables& accel = s.tracer->scene.accel;
        out.accel = {accel.milliseconds, s.tracer->scene.structure_bytes, accel.node_count, accel.reference_count, accel.depth};
        if (s.plan.ray_effects & RAY_COUNT) out.rays = s.tracer->counts;
    }
    return out;
}

Layer draw_layer(RendererState& s, const View& view, const std::string& name, const Term& term) {
    Drawing drawing{{s.plan.effects & term.effects, term.output, term.averaged ? s.plan.multisamples : 1}, glm::vec3(0), "term-" + name};
    if (term.background) drawing.background = s.environment.background, drawing.background_map = true;
    std::size_t triangles = 0;
    gpu::Image& image = record_drawing(s, view, drawing, triangles);
    s.recorder.submit_and_wait();
    return {name, read_crop(s, image)};
}

Layer run_layer(RendererState& s, const View& view, const RenderOptions& options, const std::string& name) {
    const Term term = find_term(name);
    Layer layer = s.tracer ? trace_layer(s, view, options, term) : draw_layer(s, view, name, term);
    if (term.output == OUTPUT_DEPTH) // frame units to metres; the scale is a power of two
        for (float& x : layer.image.rgba) x = static_cast<float>(x / s.geometry.frame.scale);
    return layer;
}

} // namespace

TessellationRequest tessellation_for(const Plan& plan, const View& view) {
    TessellationRequest request;
    request.eye = view.eye;
    request.pixel_angle = view.pixel_angle();
    request.subdivide = plan.subdivide;
    request.normals = plan.has("normals");
    request.detail = plan.has("detail");
    request.cubes = plan.cubes.of_object;
    request.analytic = plan.method == Method::raytrace;
    request.polygons = request.analytic || plan.has("polygon-colors") || std::ranges::find(plan.terms, "object") != plan.terms.end();
    return request;
}

Renderer::Renderer(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan)
    : state_(new RendererState{device_for(plan, device),
                               geometry,
                               plan,
                               scene.environment,
                               upload_scene(device, scene, geometry, plan),
                               gpu::Recorder(device),
                               has_no_image(plan) ? RasterTargets{} : make_targets(device, plan.size, plan.multisamples, "radiance"),
                               {},
                               {},
                               {},
                               {},
                               {},
                               {},
                               {},
                               {},
                               {},
                               {}}) {
    if (plan.has("sum")) state_->sum = make_sum(device, plan.size);
    if (plan.method == Method::raytrace) state_->tracer = make_ray_tracer(device, scene, geometry, plan);
    if (plan.method == Method::radiosity) state_->radiosity.emplace(device, scene, plan, state_->scene);
    if (plan.runs("filter")) state_->filter = make_wide_filter(device, plan);
    if (plan.runs("lattice-pixels")) state_->lattice = make_lattice(device, plan, *state_->tracer);
    state_->display = make_display(device, plan);
}

Renderer::Renderer(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

RenderOutput Renderer::render(const View& view, const RenderOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    RenderOutput out = run_image(*state_, view, options);
    if (out.done < 1 || out.stopped || state_->radiosity) return out;
    if (options.warm_up && std::chrono::steady_clock::now() - start < std::chrono::seconds(1)) out = run_image(*state_, view, options);
    for (const std::string& name : state_->plan.terms) {
        Layer layer = run_layer(*state_, view, options, name);
        if (options.stop && options.stop()) return out.done = std::nextafter(1.0, 0.0), out; // the picture is whole, its layers are not
        out.layers.push_back(std::move(layer));
    }
    return out;
}

} // namespace lightbench
