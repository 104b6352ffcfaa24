#include "render/radiosity/run.h"

#include "image/display.h"
#include "image/file_bytes.h"
#include "shared/effects.h"

#include <chrono>
#include <cmath>
#include <filesystem>

namespace lightbench {
namespace {

// The elements as they are lit by now.
gpu::Image& draw_radiosity(RendererState& s, const View& view, RenderOutput& out) {
    if (s.plan.radiosity.show == Show::light) s.radiosity->update_colors();
    const bool map = s.plan.effects & EFFECT_BACKGROUND_MAP;
    const RasterVariant variant{s.plan.effects, OUTPUT_RADIANCE, s.plan.multisamples};
    for (unsigned i = 0; i < s.plan.frames; ++i) {
        const RasterDraw draw{view, shift_of(s.plan, i), {}, s.environment.background};
        out.triangles_drawn = s.radiosity->record_draw(s.recorder, draw, cleared_targets(s.plan, s.targets, draw.background, !map));
        if (map) record_map(s.recorder, s.plan, s.scene, pipelines_for(s, variant), s.targets, draw);
        if (s.sum)
            record_accumulate(s.recorder, s.display, s.targets.resolved, s.sum, 1.0f / float(s.plan.frames),
                              i == 0 ? ACCUMULATE_FIRST : ACCUMULATE_ADD);
    }
    return s.sum ? s.sum : s.targets.resolved;
}

constexpr std::chrono::seconds kBetweenPictures(1), kBetweenSaves(5);

// Until the plan is met, or somebody says stop; pictures and the solution are handed out now and then, and kept whatever happens.
void solve_radiosity(RendererState& s, const View& view, const RenderOptions& options, RenderOutput& out) {
    using Clock = std::chrono::steady_clock;
    auto picture = Clock::now(), save = picture;
    const double goal = std::log(s.plan.radiosity.until);
    const bool keeps = !options.solution.empty() && s.plan.radiosity.solver == Solver::progressive;
    while (!(options.stop && options.stop()) && s.radiosity->advance(s.recorder, s.times)) {
        const double unshot = s.radiosity->statistics().unshot;
        if (options.progress) options.progress(std::clamp(std::log(std::max(unshot, 1e-30)) / goal, 0.0, 1.0));
        if (keeps && Clock::now() - save > kBetweenSaves) write_solution(options.solution, s.radiosity->solution()), save = Clock::now();
        if (!options.pass || Clock::now() - picture < kBetweenPictures) continue;
        RenderOutput so_far;
        read_output(s, draw_radiosity(s, view, so_far), so_far);
        options.pass(so_far), picture = Clock::now();
    }
    if (keeps) write_solution(options.solution, s.radiosity->solution());
    out.stopped = options.stop && options.stop();
    out.radiosity = s.radiosity->statistics();
}

} // namespace

gpu::Image& run_radiosity(RendererState& s, const View& view, const RenderOptions& options, RenderOutput& out) {
    if (s.plan.radiosity.show != Show::light) {
        s.radiosity->show(s.recorder, s.times, view, s.plan.size);
        return draw_radiosity(s, view, out);
    }
    if (options.anew) s.radiosity->restart();
    if (!options.solution.empty() && std::filesystem::exists(options.solution) && s.radiosity->statistics().shots == 0)
        s.radiosity->resume(read_solution(options.solution), options.solution);
    solve_radiosity(s, view, options, out);
    return draw_radiosity(s, view, out);
}

void show_hemicube(RendererState& s, const View& view, RenderOutput& out) {
    const ImageF picture = s.radiosity->show(s.recorder, s.times, view, s.plan.crop.size).value();
    if (s.plan.output == Output::radiance)
        out.radiance = picture;
    else
        out.pixels = display(picture, s.plan.exposure);
}

} // namespace lightbench
