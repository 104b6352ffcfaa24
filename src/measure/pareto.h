// The Pareto front of a curve: what nothing else beats in both time and error.
#pragma once

#include "measure/report.h"

#include <string_view>

namespace lightbench {

// Sets CostPoint::pareto of all points, metric by metric. Times whose noise overlaps are equal: from the first to the third quartile, and 5 %
// both ways at least where fewer runs were made than tell how sure a median is (kFirstLook). A point is on the front unless a point of it is
// no slower and no farther off, and better in one of the two: of equal errors the fastest are, of equal times the nearest, and twins are
// both. What is not finite is not on it.
void mark_fronts(std::vector<CostPoint>& points);

// Indices, the fastest first.
std::vector<std::size_t> front_of(const std::vector<CostPoint>& points, std::string_view metric);

} // namespace lightbench
