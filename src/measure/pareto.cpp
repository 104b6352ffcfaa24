#include "measure/pareto.h"

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

bool beats(const CostPoint& a, const CostPoint& b, std::string_view metric) {
    const auto ea = error_of(a, metric), eb = error_of(b, metric);
    if (!ea || !eb || a.device_ms > b.device_ms || *ea > *eb) return false;
    return a.device_ms < b.device_ms || *ea < *eb;
}

bool on_front(const std::vector<CostPoint>& points, const CostPoint& point, std::string_view metric) {
    return error_of(point, metric) && std::ranges::none_of(points, [&](const CostPoint& other) { return beats(other, point, metric); });
}

} // namespace

void mark_fronts(std::vector<CostPoint>& points) {
    for (CostPoint& point : points) {
        point.pareto.clear();
        for (const auto& [metric, error] : point.errors)
            if (on_front(points, point, metric)) point.pareto.insert(metric);
    }
}

std::vector<std::size_t> front_of(const std::vector<CostPoint>& points, std::string_view metric) {
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].pareto.contains(std::string(metric))) front.push_back(i);
    std::ranges::stable_sort(front, {}, [&](std::size_t i) { return points[i].device_ms; });
    return front;
}

} // namespace lightbench
