// Constants, push constants and effects of each pass over rays.
#include "render/ray_pipelines.h"

#include "render/shaders.h"
#include "shared/effects.h"
#include "shared/rays.h"

namespace lightbench {
namespace {

using namespace gpu_layout;

const char* shader_of(RayPass pass) {
    switch (pass) {
    case RayPass::eye: return "raytrace/eye.comp";
    case RayPass::trace: return "raytrace/trace.comp";
    case RayPass::shade: return "raytrace/shade.comp";
    case RayPass::shadow: return "raytrace/shadow.comp";
    case RayPass::light: return "raytrace/light.comp";
    case RayPass::gather: return "raytrace/gather.comp";
    case RayPass::film: return "raytrace/film.comp";
    case RayPass::film_points: return "raytrace/film_points.comp";
    case RayPass::film_pixels: return "raytrace/film_pixels.comp";
    }
    return "";
}

std::size_t push_of(RayPass pass) {
    switch (pass) {
    case RayPass::eye: return sizeof(EyePush);
    case RayPass::gather: return sizeof(GatherPush);
    case RayPass::film:
    case RayPass::film_points: return sizeof(FilmPush);
    case RayPass::film_pixels: return sizeof(PixelsPush);
    default: return sizeof(RayPush);
    }
}

// What may run of the illumination model in a pass: the rest of the mask would only make pipelines differ.
std::uint32_t effects_for(RayPass pass, const Plan& plan) {
    constexpr std::uint32_t kArriving = EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT | EFFECT_ATTENUATION_NONE |
                                        EFFECT_ATTENUATION_LINEAR | EFFECT_ATTENUATION_INVERSE_SQUARE;
    const std::uint32_t effects = plan.effects & ~(EFFECT_TWO_SIDED | EFFECT_VANISHING_NORMALS);
    // Of surfaces that light passes through: how clear they are.
    constexpr std::uint32_t kClear =
        EFFECT_TRANSPARENCY | EFFECT_TEXTURE_ALPHA | EFFECT_TEXTURE | EFFECT_ANY_MAPPING | EFFECT_MANY_MATERIALS;
    if (pass == RayPass::shadow) return effects & (plan.ray_effects & RAY_CLEAR_SHADOWS ? kArriving | kClear : kArriving);
    return effects;
}

} // namespace

const gpu::ComputePipeline& pipeline_of(RayTracer& tracer, const RayWork& w, RayPass pass, std::uint32_t more) {
    const std::uint32_t rays = (w.plan.ray_effects | tracer.scene.effects | more);
    gpu::ComputePipeline& pipeline = tracer.pipelines[{pass, rays}];
    if (pipeline) return pipeline;
    const gpu::Constants constants{{CONSTANT_EFFECTS, effects_for(pass, w.plan)},
                                   {CONSTANT_SHADING, SHADING_PHONG},
                                   {CONSTANT_OUTPUT, w.output},
                                   {CONSTANT_LIGHT_COUNT, pass == RayPass::light ? w.plan.light_count : 0},
                                   {CONSTANT_FETCH_STORAGE, w.scene.fetch_storage | tracer.scene.fetch_storage},
                                   {CONSTANT_RAY_EFFECTS, rays},
                                   {CONSTANT_ACCEL, static_cast<std::uint32_t>(w.plan.accel)},
                                   {CONSTANT_STACK, tracer.scene.stack},
                                   {CONSTANT_LOOSE, tracer.scene.loose}};
    pipeline = gpu::make_compute(w.device, find_shader(shader_of(pass)), constants, push_of(pass));
    return pipeline;
}

} // namespace lightbench
