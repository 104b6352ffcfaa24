#include "measure/statistics.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

double quantile(const std::vector<double>& sorted, double share) {
    const double at = share * double(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - double(below)) * (sorted[above] - sorted[below]);
}

} // namespace

Quartiles quartiles(std::vector<double> sample) {
    std::ranges::sort(sample);
    return {quantile(sample, 0.25), quantile(sample, 0.5), quantile(sample, 0.75)};
}

// David and Nagaraja 2003, "Order Statistics", 3rd ed., sec. 7.1: the runs below the median are binomial with p = 1/2, so the r-th smallest and
// the r-th largest of n enclose it with probability 1 - 2 sum_{i < r} C(n, i) / 2^n.
std::optional<Interval> median_interval(std::vector<double> sample, double confidence) {
    std::ranges::sort(sample);
    const std::size_t n = sample.size();
    std::size_t r = 0;
    double term = std::exp2(-double(n)), outside = 0;
    while (2 * (r + 1) <= n && 1 - 2 * (outside + term) >= confidence) {
        outside += term;
        term *= double(n - r) / double(r + 1);
        ++r;
    }
    if (r == 0) return std::nullopt;
    return Interval{sample[r - 1], sample[n - r]};
}

bool is_settled(const std::vector<double>& sample, double share, double confidence) {
    const auto interval = median_interval(sample, confidence);
    if (!interval) return false;
    const double median = quartiles(sample).median;
    return median > 0 && interval->low >= (1 - share) * median && interval->high <= (1 + share) * median;
}

std::optional<double> log_slope(const std::vector<std::pair<double, double>>& points) {
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (const auto& [x, y] : points) mean_x += std::log(x) / double(points.size()), mean_y += std::log(y) / double(points.size());
    for (const auto& [x, y] : points) {
        const double dx = std::log(x) - mean_x;
        xx += dx * dx, xy += dx * (std::log(y) - mean_y);
    }
    if (points.size() < 2 || !(xx > 1e-20)) return std::nullopt; // logarithms of equal numbers differ from their mean by roundings
    return xy / xx;
}

} // namespace lightbench
