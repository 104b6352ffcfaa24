// Which setting of a measured curve to take for a time or an error. Pure.
#pragma once

#include "measure/report.h"

namespace lightbench {

struct Wish {
    std::optional<double> milliseconds; // at most, on the device
    std::optional<double> error;        // at most
    std::string metric;
    double time_scale = 1; // of the picture that is wanted over the one that was measured
};

struct Choice {
    const CostPoint* point = nullptr; // of the curve; null: no point has the metric
    bool fits = false;                // else the nearest offer: the fastest of what is near enough, or the nearest of what is fast enough
    bool near = false;                // its error is what was wished; of a choice that does not fit: time is what is missing
    std::size_t front = 0;            // points on it
};

// On the front of the metric: the cheapest that is near enough if an error was named, else the nearest that is fast enough.
Choice choose(const CostCurve& curve, const Wish& wish);

} // namespace lightbench
