#include "measure/sweep.h"

#include "image/display.h"
#include "measure/analysis.h"
#include "measure/picture_errors.h"
#include "measure/statistics.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

void add_note(CostPoint& point, const std::string& note) {
    point.note += point.note.empty() ? note : "; " + note;
}

void judge(CostPoint& point, const ImageF& reference, const Rendering& rendering, float exposure) {
    point.errors = picture_errors(reference, rendering.radiance, exposure);
    if (rendering.closure) point.errors["closure"] = *rendering.closure;
    if (const std::size_t n = count_non_finite(rendering.radiance); n > 0) add_note(point, fmt::format("{} pixels are not finite", n));
}

void set_times(CostPoint& point, const Timed& timed) {
    const Quartiles q = quartiles(timed.milliseconds);
    point.device_ms = q.median, point.q1_ms = q.q1, point.q3_ms = q.q3;
    point.runs = static_cast<unsigned>(timed.milliseconds.size()), point.settled = timed.settled;
}

} // namespace

Swept sweep(CostCurve curve, const Knob& knob, const References& references, const SweepRunner& runner, const RoundLimits& limits,
            float exposure) {
    curve.reference_error = picture_errors(references.first, references.second, exposure);
    std::vector<ImageF> pictures;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        Rendering rendering = runner.run(i);
        judge(curve.points[i], references.first, rendering, exposure);
        runner.take_picture(i, rendering);
        pictures.push_back(std::move(rendering.radiance));
    }
    std::vector<bool> repeats(curve.points.size(), true);
    const auto run = [&](std::size_t i) {
        const Rendering rendering = runner.run(i);
        if (rendering.radiance.rgba != pictures[i].rgba) repeats[i] = false;
        return rendering.milliseconds;
    };
    const std::vector<Timed> timed = time_in_rounds(curve.points.size(), run, runner.wall, limits);
    for (std::size_t i = 0; i < timed.size(); ++i) {
        set_times(curve.points[i], timed[i]);
        if (!repeats[i]) add_note(curve.points[i], "its runs gave different pictures");
    }
    const std::size_t broken = conclude(curve, knob);
    return {std::move(curve), broken};
}

} // namespace lightbench
