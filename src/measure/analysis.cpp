#include "measure/analysis.h"

#include "measure/pareto.h"
#include "measure/rounds.h"
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
        if (const auto scale = knob.scale ? knob.scale(point.value, point.options) : std::nullopt)
            groups[scale->group].push_back({scale->x, &point});
    for (auto& [name, placed] : groups) std::ranges::stable_sort(placed, {}, &Placed::x);
    return groups;
}

// An error that is no larger than twice what its reference is uncertain by says more of the reference.
constexpr double kDrowned = 2;

// Of the points through which a slope is drawn, and those that it leaves out.
struct Fitted {
    std::vector<std::pair<double, double>> points;
    std::size_t drowned = 0, not_finite = 0;
};

Fitted points_to_fit(const CostCurve& curve, const std::vector<Placed>& placed, std::string_view metric) {
    Fitted fitted;
    const double least = kDrowned * error_in(curve.reference_error, metric);
    for (const Placed& p : placed) {
        const double e = error_in(p.point->errors, metric);
        if (!std::isfinite(e))
            ++fitted.not_finite;
        else if (e > least)
            fitted.points.emplace_back(p.x, e);
        else
            ++fitted.drowned;
    }
    return fitted;
}

std::string left_out(const Fitted& fitted) {
    std::vector<std::string> reasons;
    if (fitted.drowned > 0) reasons.push_back(fmt::format("of {} the error is below twice the reference's uncertainty", fitted.drowned));
    if (fitted.not_finite > 0) reasons.push_back(fmt::format("of {} it is not finite", fitted.not_finite));
    if (reasons.empty()) return "";
    return fmt::format("fitted to {} of {} points: {}", fitted.points.size(), fitted.points.size() + fitted.drowned + fitted.not_finite,
                       fmt::join(reasons, ", "));
}

// Steeper than theory is no fault where theory is of the worst scene. Returns how many expectations are broken.
std::size_t note_slope(CostCurve& curve, const Slope& slope, const ExpectedSlope& expected) {
    if (!expected.theory || expected.tolerance == 0) return 0;
    const double off = slope.measured - *expected.theory;
    if (off <= expected.tolerance && (!expected.everywhere || off >= -expected.tolerance)) return 0;
    curve.notes.push_back(fmt::format("{}the slope{} of {} is {:.3f}, and theory says {:g} +- {:g}{}",
                                      expected.everywhere ? "not as expected: " : "",
                                      slope.of.empty() ? "" : fmt::format(" ({})", slope.of), slope.metric, slope.measured,
                                      *expected.theory, expected.tolerance, expected.everywhere ? "" : ": this scene is another case"));
    return expected.everywhere ? 1 : 0;
}

std::size_t add_slope(CostCurve& curve, const Knob& knob, const std::string& group, const std::vector<Placed>& placed,
                      std::string_view metric) {
    const Fitted fitted = points_to_fit(curve, placed, metric);
    const auto slope = log_slope(fitted.points);
    if (!slope || fitted.points.size() < 3) return 0;
    Slope out{group, std::string(metric), std::string(knob.axis), *slope, std::nullopt, ""};
    std::size_t broken = 0;
    for (const ExpectedSlope& expected : knob.slopes)
        if (expected.group == group && expected.metric == metric) {
            out.theory = expected.theory, out.why = expected.why;
            broken += note_slope(curve, out, expected);
        }
    if (const std::string omitted = left_out(fitted); !omitted.empty()) out.why += (out.why.empty() ? "" : "; ") + omitted;
    curve.slopes.push_back(std::move(out));
    return broken;
}

std::size_t note_rises(CostCurve& curve, const std::vector<Placed>& placed, std::string_view metric) {
    std::size_t broken = 0;
    const double unsure = error_in(curve.reference_error, metric);
    for (std::size_t i = 1; i < placed.size(); ++i) {
        const CostPoint &before = *placed[i - 1].point, &after = *placed[i].point;
        const double a = error_in(before.errors, metric), b = error_in(after.errors, metric);
        if (std::isfinite(b) && b <= a + unsure) continue; // a NaN breaks it, as it should
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

// Errors that are compared with a reference of which nothing is known say nothing.
std::size_t note_reference(CostCurve& curve) {
    if (std::isfinite(error_in(curve.reference_error, curve.metric))) return 0;
    curve.notes.push_back(fmt::format("not as expected: the {} by which the reference is uncertain is not finite, so that nothing can be "
                                      "said of how errors fall",
                                      curve.metric));
    return 1;
}

void note_drowned(CostCurve& curve) {
    const double least = kDrowned * error_in(curve.reference_error, curve.metric);
    for (CostPoint& point : curve.points)
        if (least > 0 && error_in(point.errors, curve.metric) <= least)
            point.note += fmt::format("{}its error is below twice what the reference is uncertain by", point.note.empty() ? "" : "; ");
}

} // namespace

void note_unsettled(CostCurve& curve) {
    std::vector<std::string_view> values;
    unsigned runs = 0;
    for (const CostPoint& point : curve.points)
        if (!point.settled && std::isfinite(point.device_ms)) values.push_back(point.value), runs = point.runs;
    if (values.empty()) return;
    const std::string names = fmt::format("{}", fmt::join(values, ", "));
    if (runs < kFirstLook)
        curve.notes.push_back(fmt::format("{} run{} too few to tell how sure a median time is ({} are needed): {}", runs,
                                          runs == 1 ? " is" : "s are", kFirstLook, names));
    else
        curve.notes.push_back(
            fmt::format("after {} runs the 95 % interval of the median time is still wider than 5 % of it both ways: {}", runs, names));
}

std::size_t conclude(CostCurve& curve, const Knob& knob) {
    mark_fronts(curve.points);
    std::size_t broken = curve.time_only ? note_differences(curve) : note_reference(curve);
    note_drowned(curve);
    for (const auto& [group, placed] : groups_of(curve, knob)) {
        if (std::isfinite(error_in(curve.reference_error, curve.metric))) broken += note_rises(curve, placed, curve.metric);
        broken += add_slope(curve, knob, group, placed, curve.metric);
        for (const ExpectedSlope& expected : knob.slopes)
            if (expected.group == group && expected.metric != curve.metric)
                broken += add_slope(curve, knob, group, placed, expected.metric);
    }
    note_unsettled(curve);
    return broken;
}

} // namespace lightbench
