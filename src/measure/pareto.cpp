#include "measure/pareto.h"

#include "measure/rounds.h"
#include "measure/statistics.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

// Nothing: it takes no part.
std::optional<double> error_of(const CostPoint& point, std::string_view metric) {
    const auto it = point.errors.find(metric);
    if (it == point.errors.end() || !std::isfinite(it->second) || !std::isfinite(point.device_ms)) return std::nullopt;
    return it->second;
}

Interval time_of(const CostPoint& point) {
    constexpr double kUnknown = 0.05; // what a settled median is sure to
    const double share = point.runs < kFirstLook ? kUnknown : 0;
    Interval noise{(1 - share) * point.device_ms, (1 + share) * point.device_ms};
    if (point.q1_ms < noise.low) noise.low = point.q1_ms; // false for NaN
    if (point.q3_ms > noise.high) noise.high = point.q3_ms;
    return noise;
}

// Of `a` no farther off than `b`.
bool beats(const CostPoint& a, const CostPoint& b, std::string_view metric) {
    const Interval ta = time_of(a), tb = time_of(b);
    const bool slower = ta.low > tb.high, faster = ta.high < tb.low;
    return !slower && (faster || error_of(a, metric) < error_of(b, metric));
}

// From the nearest to the fastest, against those that are on it already: equality of times is not transitive, and what a point would hide
// that is hidden itself must stay.
void mark_front(std::vector<CostPoint>& points, const std::string& metric) {
    std::vector<CostPoint*> order, front;
    for (CostPoint& point : points)
        if (error_of(point, metric)) order.push_back(&point);
    std::ranges::stable_sort(order, {}, [&](const CostPoint* p) { return std::pair(error_of(*p, metric), p->device_ms); });
    for (CostPoint* point : order)
        if (std::ranges::none_of(front, [&](const CostPoint* other) { return beats(*other, *point, metric); })) front.push_back(point);
    for (CostPoint* point : front) point->pareto.insert(metric);
}

} // namespace

void mark_fronts(std::vector<CostPoint>& points) {
    std::set<std::string> metrics;
    for (CostPoint& point : points) {
        point.pareto.clear();
        for (const auto& [metric, error] : point.errors) metrics.insert(metric);
    }
    for (const std::string& metric : metrics) mark_front(points, metric);
}

std::vector<std::size_t> front_of(const std::vector<CostPoint>& points, std::string_view metric) {
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].pareto.contains(std::string(metric))) front.push_back(i);
    std::ranges::stable_sort(front, {}, [&](std::size_t i) { return points[i].device_ms; });
    return front;
}

} // namespace lightbench
