#include "measure/budget.h"

#include "measure/pareto.h"

#include <algorithm>

namespace lightbench {
namespace {

double error_of(const CostPoint& point, const Wish& wish) {
    return point.errors.at(wish.metric); // what is on the front of a metric has it
}

bool is_near(const CostPoint& point, const Wish& wish) {
    return !wish.error || error_of(point, wish) <= *wish.error;
}

bool is_fast(const CostPoint& point, const Wish& wish) {
    return !wish.milliseconds || point.device_ms * wish.time_scale <= *wish.milliseconds;
}

} // namespace

// The front runs from the fastest to the nearest: what is fast enough is its beginning, what is near enough its end.
Choice choose(const CostCurve& curve, const Wish& wish) {
    const std::vector<std::size_t> front = front_of(curve.points, wish.metric);
    Choice choice{nullptr, false, false, front.size()};
    if (front.empty()) return choice;
    const auto at = [&](std::size_t i) { return &curve.points[i]; };
    if (wish.error) {
        const auto near = std::ranges::find_if(front, [&](std::size_t i) { return is_near(*at(i), wish); });
        choice.point = at(near == front.end() ? front.back() : *near);
    } else {
        const auto slow = std::ranges::find_if(front, [&](std::size_t i) { return !is_fast(*at(i), wish); });
        choice.point = at(slow == front.begin() ? front.front() : *(slow - 1));
    }
    choice.near = is_near(*choice.point, wish);
    choice.fits = choice.near && is_fast(*choice.point, wish);
    return choice;
}

} // namespace lightbench
