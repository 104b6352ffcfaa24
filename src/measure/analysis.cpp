#include "measure/analysis.h"

#include "measure/pareto.h"
#include "measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace lightbench {
namespace {

struct Placed {
    double x = 1;
    const CostPoint* point = nullptr;
};

double error_in(const Errors& errors, std::string_view metric) {
    const auto it = errors.find(metric);
    return it == errors.end() ? 0 : it->second;
}

// Points by group, each sorted along its axis.
std::map<std::string, std::vector<Placed>> groups_of(const CostCurve& curve, const Knob& knob) {
    std::map<std::string, std::vector<Placed>> groups;
    for (const CostPoint& point : curve.points)
        if (const auto scale = knob.scale ? knob.scale(point.value) : std::nullopt) groups[scale->group].push_back({scale->x, &point});
    for (auto& [name, placed] : groups) std::ranges::stable_sort(placed, {}, &Placed::x);
    return groups;
}

// An error that is no larger than twice what its reference is uncertain by says more of the reference.
constexpr double kDrowned = 2;

void add_slope(CostCurve& curve, const Knob& knob, const std::string& group, const std::vector<Placed>& placed, std::string_view metric) {
    std::vector<std::pair<double, double>> fitted;
    const double least = kDrowned * error_in(curve.reference_error, metric);
    for (const Placed& p : placed)
        if (const double e = error_in(p.point->errors, metric); std::isfinite(e) && e > least) fitted.emplace_back(p.x, e);
    const auto slope = log_slope(fitted);
    if (!slope || fitted.size() < 3) return;
    Slope out{group, std::string(metric), std::string(knob.axis), *slope, std::nullopt, ""};
    for (const ExpectedSlope& expected : knob.slopes)
        if (expected.group == group && expected.metric == metric) out.theory = expected.theory, out.why = expected.why;
    if (fitted.size() < placed.size())
        out.why += fmt::format("{}fitted to {} of {} points: the others' errors are below twice the reference's uncertainty",
                               out.why.empty() ? "" : "; ", fitted.size(), placed.size());
    curve.slopes.push_back(std::move(out));
}

std::size_t note_rises(CostCurve& curve, const std::vector<Placed>& placed, std::string_view metric) {
    std::size_t broken = 0;
    const double unsure = error_in(curve.reference_error, metric);
    for (std::size_t i = 1; i < placed.size(); ++i) {
        const CostPoint &before = *placed[i - 1].point, &after = *placed[i].point;
        const double a = error_in(before.errors, metric), b = error_in(after.errors, metric);
        if (b <= a + unsure) continue; // a NaN breaks it, as it should
        curve.notes.push_back(fmt::format(
            "not as expected: from {} to {} the {} rises from {:.4g} to {:.4g}; it should not rise by more than the {:.2g} that the "
            "reference is uncertain by",
            before.value, after.value, metric, a, b, unsure));
        ++broken;
    }
    return broken;
}

std::size_t note_differences(CostCurve& curve) {
    std::size_t broken = 0;
    for (const CostPoint& point : curve.points) {
        const double most = error_in(point.errors, "maximum");
        if (most == 0) continue;
        curve.notes.push_back(
            fmt::format("not as expected: the picture of {} differs from the reference by {:.4g}; it should be equal", point.value, most));
        ++broken;
    }
    return broken;
}

void note_unsettled(CostCurve& curve) {
    std::vector<std::string_view> values;
    for (const CostPoint& point : curve.points)
        if (!point.settled) values.push_back(point.value);
    if (values.empty()) return;
    const unsigned runs = curve.points.front().runs;
    curve.notes.push_back(fmt::format("after {} run{} the 95 % interval of the median time is still wider than 5 % of it both ways: {}",
                                      runs, runs == 1 ? "" : "s", fmt::join(values, ", ")));
}

} // namespace

std::size_t conclude(CostCurve& curve, const Knob& knob) {
    mark_fronts(curve.points);
    std::size_t broken = curve.time_only ? note_differences(curve) : 0;
    for (const auto& [group, placed] : groups_of(curve, knob)) {
        broken += note_rises(curve, placed, curve.metric);
        add_slope(curve, knob, group, placed, curve.metric);
        for (const ExpectedSlope& expected : knob.slopes)
            if (expected.group == group && expected.metric != curve.metric) add_slope(curve, knob, group, placed, expected.metric);
    }
    note_unsettled(curve);
    return broken;
}

} // namespace lightbench
