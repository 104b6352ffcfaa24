// Findings about pairs as the data that cost reports are made of.
#include "measure/function_curves.h"

#include "measure/analysis.h"
#include "measure/pareto.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace lightbench {

namespace {

// The worst of the results that are numbers as expected says nothing of a form whose others are wrong where the stable form is right. Of
// decisions it is the wrong ones that are measured, and they have no ulp.
Errors errors_of(const kernels::Form& form, const kernels::PairFinding& finding) {
    const bool wrong = form.errors.wrong > 0 && finding.forms.front().errors.wrong == 0;
    if (finding.pair.distance) return {{"relative", form.errors.relative}, {"wrong", form.errors.wrong}};
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    return {
        {"relative", wrong ? kInfinite : form.errors.relative}, {"ulp", wrong ? kInfinite : form.errors.ulp}, {"wrong", form.errors.wrong}};
}

std::string note_of(const kernels::Form& form, bool decides) {
    std::string note;
    if (form.errors.wrong > 0)
        note =
            decides
                ? fmt::format("{:.3g} % of the decisions are wrong, the worst {:.3g} of the threshold away from it",
                              100 * form.errors.wrong, form.errors.relative)
                : fmt::format("{:.3g} % of the results are not finite, or wrong altogether; the worst of the others errs by {:.3g} of it",
                              100 * form.errors.wrong, form.errors.relative);
    if (std::isnan(form.cost.median))
        note += fmt::format("{}its time is lost in the noise of the loop around it", note.empty() ? "" : "; ");
    return note;
}

} // namespace

CostCurve curve_of(const kernels::PairFinding& finding) {
    const kernels::Pair& pair = finding.pair;
    CostCurve curve;
    curve.knob = fmt::format("{} formula", pair.name);
    curve.meaning = fmt::format("{} against {}; {}; milliseconds are of 10^6 calls", pair.stable, pair.naive, pair.domain);
    curve.reference = "oracle in double, nearer to 60 digits than a thousandth of the stable form's bound";
    curve.metric = "relative";
    for (const kernels::Form& form : finding.forms) {
        if (!form.lacking.empty()) {
            curve.notes.push_back(fmt::format("no {}: {}", form.name, form.lacking));
            continue;
        }
        CostPoint point;
        point.value = form.name;
        point.errors = errors_of(form, finding);
        point.device_ms = form.cost.median, point.q1_ms = form.cost.q1, point.q3_ms = form.cost.q3; // nanoseconds a call are that
        point.runs = form.cost.runs, point.settled = form.cost.settled;
        point.command = fmt::format("lightbench numerics --pairs --only \"{}\"", pair.name);
        point.note = note_of(form, finding.pair.distance != nullptr);
        curve.points.push_back(point);
    }
    mark_fronts(curve.points);
    note_unsettled(curve);
    return curve;
}

std::vector<CostCurve> function_curves(gpu::Device& device, const kernels::PairLimits& limits, const std::function<bool()>& stop) {
    std::vector<CostCurve> curves;
    for (const kernels::Pair& pair : kernels::all_pairs()) {
        if (stop && stop()) break;
        curves.push_back(curve_of(kernels::measure_pair(device, pair, limits)));
    }
    return curves;
}

} // namespace lightbench
