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

void judge(CostPoint& point, const Knob& knob, const ImageF& reference, const Rendering& rendering, float exposure) {
    point.errors = picture_errors(reference, rendering.radiance, exposure);
    if (knob.computed) point.errors.merge(knob.computed(point.value));
    if (const std::size_t n = count_non_finite(rendering.radiance); n > 0) add_note(point, fmt::format("{} pixels are not finite", n));
}

void set_times(CostPoint& point, const Timed& timed) {
    const Quartiles q = quartiles(timed.milliseconds);
    point.device_ms = q.median, point.q1_ms = q.q1, point.q3_ms = q.q3;
    point.runs = static_cast<unsigned>(timed.milliseconds.size()), point.settled = timed.settled;
}

// A knob that changes nothing here has points that differ by noise alone.
void note_equality(CostCurve& curve, const std::vector<ImageF>& pictures) {
    if (curve.time_only || pictures.size() < 2) return;
    if (std::ranges::all_of(pictures, [&](const ImageF& picture) { return picture.rgba == pictures.front().rgba; }))
        curve.notes.emplace_back("all pictures of this knob are equal in this scene");
}

} // namespace

Swept sweep(CostCurve curve, const Knob& knob, const References& references, const SweepRunner& runner, const RoundLimits& limits,
            float exposure) {
    const auto stopped = [&] { return runner.stop && runner.stop(); };
    curve.reference_error = picture_errors(references.first, references.second, exposure);
    std::vector<ImageF> pictures;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        Rendering rendering = runner.run(i);
        if (stopped()) return {std::move(curve), 0, true};
        judge(curve.points[i], knob, references.first, rendering, exposure);
        runner.take_picture(i, rendering);
        pictures.push_back(std::move(rendering.radiance));
    }
    std::vector<bool> repeats(curve.points.size(), true);
    const auto run = [&](std::size_t i) {
        const Rendering rendering = runner.run(i);
        if (rendering.radiance.rgba != pictures[i].rgba) repeats[i] = false;
        return rendering.milliseconds;
    };
    const std::vector<Timed> timed = time_in_rounds(curve.points.size(), run, runner.wall, limits, runner.stop);
    if (timed.empty() || timed.front().milliseconds.empty()) return {std::move(curve), 0, true};
    for (std::size_t i = 0; i < timed.size(); ++i) {
        set_times(curve.points[i], timed[i]);
        if (!repeats[i]) add_note(curve.points[i], "its runs gave different pictures");
    }
    note_equality(curve, pictures);
    const std::size_t broken = conclude(curve, knob);
    return {std::move(curve), broken, false};
}

} // namespace lightbench
