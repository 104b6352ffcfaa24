// Findings about pairs as the data that cost reports are made of.
#include "measure/function_curves.h"

#include <fmt/format.h>

namespace lightbench {

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
        point.errors = {{"relative", form.errors.relative}, {"ulp", form.errors.ulp}, {"wrong", form.errors.wrong}};
        point.device_ms = form.cost.median, point.q1_ms = form.cost.q1, point.q3_ms = form.cost.q3; // nanoseconds a call are that
        point.runs = form.cost.runs, point.settled = form.cost.settled;
        point.command = fmt::format("lightbench numerics --pairs --only \"{}\"", pair.name);
        if (form.errors.wrong > 0)
            point.note = fmt::format("{:.3g} % of the results are not finite, or wrong altogether", 100 * form.errors.wrong);
        curve.points.push_back(point);
    }
    return curve;
}

std::vector<CostCurve> function_curves(gpu::Device& device, const kernels::PairLimits& limits) {
    std::vector<CostCurve> curves;
    for (const kernels::Pair& pair : kernels::all_pairs()) curves.push_back(curve_of(kernels::measure_pair(device, pair, limits)));
    return curves;
}

} // namespace lightbench
